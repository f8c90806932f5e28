/// Flipside's rules for contacts, in Chipmunk's callbacks: how pairs bounce, sensors, gates; and what is
/// reported.

#include <algorithm>
#include <cmath>
#include <iterator>
#include <tuple>

#include "space.hpp"

namespace flipside_chipmunk {

namespace {

struct Meeting {
    Pair pair;
    cpBody* ball = nullptr;
    cpBody* other = nullptr;
    cpShape* other_shape = nullptr;
    bool swapped = false;  ///< Chipmunk's first shape is the other one
};

const Tag& tag_of(const cpShape* shape) {
    return *static_cast<const Tag*>(cpShapeGetUserData(shape));
}

/// False where no ball takes part.
bool meeting_of(const cpArbiter* arbiter, Meeting& meeting) {
    cpShape *a = nullptr, *b = nullptr;
    cpArbiterGetShapes(arbiter, &a, &b);
    const Tag &first = tag_of(a), &second = tag_of(b);
    if (!first.is_ball && !second.is_ball) return false;
    meeting.swapped = !first.is_ball || (second.is_ball && second.index < first.index);
    if (meeting.swapped) std::swap(a, b);
    meeting.pair = {tag_of(a).index, tag_of(b).is_ball, tag_of(b).index};
    meeting.ball = cpShapeGetBody(a);
    meeting.other = cpShapeGetBody(b);
    meeting.other_shape = b;
    return true;
}

/// From the other to the ball. Chipmunk's goes from its first shape to its second.
cpVect normal_of(const cpArbiter* arbiter, const Meeting& meeting) {
    const cpVect normal = cpArbiterGetNormal(arbiter);
    return meeting.swapped ? normal : cpvneg(normal);
}

/// Of the deepest point, on the surface of the other.
cpVect point_of(const cpArbiter* arbiter, const Meeting& meeting, double& separation) {
    const cpContactPointSet set = cpArbiterGetContactPointSet(arbiter);
    int deepest = 0;
    for (int i = 1; i < set.count; ++i)
        if (set.points[i].distance < set.points[deepest].distance) deepest = i;
    separation = set.points[deepest].distance;
    return meeting.swapped ? set.points[deepest].pointA : set.points[deepest].pointB;
}

/// m/s, above 0 where the ball comes nearer.
double approach_of(const Meeting& meeting, cpVect point, cpVect normal) {
    const cpVect relative = cpvsub(cpBodyGetVelocityAtWorldPoint(meeting.ball, point),
                                   cpBodyGetVelocityAtWorldPoint(meeting.other, point));
    return -cpvdot(relative, normal);
}

Space& space_of(cpDataPointer data) {
    return *static_cast<Space*>(data);
}

}  // namespace

void Space::listen() {
    cpCollisionHandler* const handler = cpSpaceAddDefaultCollisionHandler(space_.get());
    handler->userData = this;
    handler->beginFunc = [](cpArbiter* arbiter, cpSpace*, cpDataPointer data) -> cpBool {
        return space_of(data).begin(arbiter);
    };
    handler->preSolveFunc = [](cpArbiter* arbiter, cpSpace*, cpDataPointer data) -> cpBool {
        return space_of(data).before_solve(arbiter);
    };
    handler->postSolveFunc = [](cpArbiter* arbiter, cpSpace*, cpDataPointer data) {
        space_of(data).after_solve(arbiter);
    };
    handler->separateFunc = [](cpArbiter* arbiter, cpSpace*, cpDataPointer data) {
        space_of(data).separate(arbiter);
    };
}

bool Space::begin(cpArbiter* arbiter) {
    Meeting meeting{};
    if (!meeting_of(arbiter, meeting)) return false;
    if (meeting.pair.with_ball) return true;
    const std::uint32_t flags = parts_[meeting.pair.other].is.flags;
    if ((flags & (FLIPSIDE_PART_SENSOR | FLIPSIDE_PART_GATE)) == 0) return true;
    if (++touching_[meeting.pair] > 1) return true;
    if ((flags & FLIPSIDE_PART_SENSOR) != 0)
        report(FLIPSIDE_SENSOR_BEGIN, meeting.pair);
    else
        meet_gate(meeting.pair);
    return true;
}

/// Decides, once, whether the gate lets the ball through. An open one lets everything through that touches
/// it.
void Space::meet_gate(const Pair& pair) {
    Part& gate = parts_[pair.other];
    const auto was_blocked = blocked_.find(pair);
    if (was_blocked != blocked_.end()) return;
    const cpVect from_gate =
        cpvsub(cpBodyGetPosition(balls_.at(pair.ball).body), cpSegmentShapeGetA(gate.shapes.front()));
    const cpVect across = cpSegmentShapeGetNormal(gate.shapes.front());
    const double side = cpvdot(from_gate, across) * cpvdot(vec(gate.is.normal), across);
    blocked_[pair] = !gate.open && side > 0;
    if (gate.open || blocked_[pair]) {
        if (!gate.open) report(FLIPSIDE_GATE_BLOCKED, pair);
        return;
    }
    gate.open = true;
    report(FLIPSIDE_GATE_OPENED, pair);
    for (auto& [other, blocks] : blocked_)
        if (other.other == pair.other && std::exchange(blocks, false)) report(FLIPSIDE_GATE_LEFT, other);
}

void Space::leave_gate(const Pair& pair) {
    Part& gate = parts_[pair.other];
    const auto at = blocked_.find(pair);
    if (at != blocked_.end() && at->second) report(FLIPSIDE_GATE_LEFT, pair);
    if (at != blocked_.end()) blocked_.erase(at);
    const auto is_in_it = [&](const auto& one) { return one.first.other == pair.other && !one.second; };
    if (!gate.open || std::any_of(blocked_.begin(), blocked_.end(), is_in_it)) return;
    gate.open = false;
    report(FLIPSIDE_GATE_CLOSED, pair);
}

bool Space::before_solve(cpArbiter* arbiter) {
    Meeting meeting{};
    if (!meeting_of(arbiter, meeting)) return false;
    const Pair& pair = meeting.pair;
    if (!pair.with_ball &&
        (parts_[pair.other].open || (parts_[pair.other].is.flags & FLIPSIDE_PART_SENSOR) != 0))
        return false;
    double separation = 0;
    const cpVect point = point_of(arbiter, meeting, separation), normal = normal_of(arbiter, meeting);
    const double approach = approach_of(meeting, point, normal);
    if (approach < rest_speed_ || approach <= 0) {
        cpArbiterSetRestitution(arbiter, 0);
        return true;
    }
    const flipside_material& mine = materials_[balls_.at(pair.ball).is.material];
    const flipside_material& its =
        materials_[pair.with_ball ? balls_.at(pair.other).is.material : parts_[pair.other].is.material];
    const double kick = std::max(mine.kick, its.kick);
    cpArbiterSetRestitution(arbiter, std::max(mine.restitution * its.restitution, kick / approach));
    flipside_event& hit = hits_[pair];
    if (hit.speed >= approach) return true;
    hit.point = vec(point);
    hit.normal = vec(normal);
    hit.speed = approach;
    return true;
}

/// The parts of an arc are one part: their impulses are added up.
void Space::after_solve(cpArbiter* arbiter) {
    Meeting meeting{};
    if (!meeting_of(arbiter, meeting)) return;
    const auto hit = hits_.find(meeting.pair);
    if (hit == hits_.end()) return;
    hit->second.impulse += std::abs(cpvdot(cpArbiterTotalImpulse(arbiter), normal_of(arbiter, meeting)));
}

void Space::separate(cpArbiter* arbiter) {
    Meeting meeting{};
    if (!meeting_of(arbiter, meeting)) return;
    const auto at = touching_.find(meeting.pair);
    if (at == touching_.end() || --at->second > 0) return;
    touching_.erase(at);
    if ((parts_[meeting.pair.other].is.flags & FLIPSIDE_PART_SENSOR) != 0)
        report(FLIPSIDE_SENSOR_END, meeting.pair);
    else
        leave_gate(meeting.pair);
}

void Space::report(flipside_event_kind kind, const Pair& pair, cpVect point, cpVect normal, double speed,
                   double impulse) {
    (in_step_ ? events_ : between_steps_)
        .push_back({now_, static_cast<std::uint32_t>(kind), pair.ball, pair.with_ball ? 1U : 0U, pair.other,
                    vec(point), vec(normal), speed, impulse});
}

void Space::step(const flipside_step& step) {
    events_ = std::exchange(between_steps_, {});
    std::erase_if(events_, [&](const flipside_event& event) { return !balls_.contains(event.ball); });
    for (flipside_event& event : events_) event.time = step.time;
    in_step_ = true;
    for (int i = 0; i < options_.substeps; ++i) {
        const double from = step.dt * i / options_.substeps, to = step.dt * (i + 1) / options_.substeps;
        now_ = step.time + to;
        for (std::uint32_t j = 0; j < step.motion_count; ++j) {
            const flipside_motion& motion = step.motions[j];
            const auto angle = [&](double t) {
                return motion.angle + motion.rate * std::min(t, motion.until_stop);
            };
            cpBodySetAngle(parts_[motion.part].body, angle(from));
            cpBodySetAngularVelocity(parts_[motion.part].body, (angle(to) - angle(from)) / (to - from));
        }
        hits_.clear();
        cpSpaceStep(space_.get(), to - from);
        for (const auto& [pair, hit] : hits_)
            report(FLIPSIDE_IMPACT, pair, vec(hit.point), vec(hit.normal), hit.speed, hit.impulse);
    }
    // What no ball touches any more was left before this space was made.
    for (std::uint32_t part = 0; part < parts_.size(); ++part)
        if (parts_[part].open &&
            std::none_of(blocked_.begin(), blocked_.end(),
                         [&](const auto& one) { return one.first.other == part; }) &&
            !balls_.empty())
            leave_gate({balls_.begin()->first, false, part});
    in_step_ = false;
    look_for_contacts();
    report_touches();
    // Chipmunk calls in an order that depends on addresses.
    std::stable_sort(events_.begin(), events_.end(), [](const flipside_event& a, const flipside_event& b) {
        return std::tuple(a.time, a.ball, a.other_is_ball, a.other) <
               std::tuple(b.time, b.ball, b.other_is_ball, b.other);
    });
}

/// The deepest of every pair, by ball, then other.
void Space::look_for_contacts() {
    std::map<Pair, flipside_contact> found;
    for (const auto& [number, ball] : balls_)
        cpBodyEachArbiter(
            ball.body,
            [](cpBody*, cpArbiter* arbiter, void* data) {
                Meeting meeting{};
                if (!meeting_of(arbiter, meeting)) return;
                double separation = 0;
                const cpVect point = point_of(arbiter, meeting, separation);
                auto& list = *static_cast<std::map<Pair, flipside_contact>*>(data);
                const auto [at, is_new] = list.try_emplace(meeting.pair);
                if (!is_new && at->second.separation <= separation) return;
                at->second = {meeting.pair.ball, meeting.pair.with_ball ? 1U : 0U, meeting.pair.other, 0,
                              vec(point),        vec(normal_of(arbiter, meeting)), separation};
            },
            &found);
    contacts_.clear();
    for (const auto& [pair, contact] : found) contacts_.push_back(contact);
}

/// A touch begins where a ball neither comes nor goes at the end of a step, and ends when they no longer
/// touch.
void Space::report_touches() {
    in_step_ = true;
    std::vector<Pair> now;
    for (const flipside_contact& contact : contacts_) {
        const Pair pair{contact.ball, contact.other_is_ball != 0, contact.other};
        const bool was_held = std::binary_search(held_.begin(), held_.end(), pair);
        Meeting meeting{};
        meeting.ball = balls_.at(pair.ball).body;
        meeting.other = pair.with_ball ? balls_.at(pair.other).body : parts_[pair.other].body;
        const double approach = approach_of(meeting, vec(contact.point), vec(contact.normal));
        if (!was_held && std::abs(approach) > rest_speed_) continue;
        if (!was_held) report(FLIPSIDE_BEGIN, pair, vec(contact.point), vec(contact.normal));
        now.push_back(pair);
    }
    for (const Pair& pair : held_)
        if (!std::binary_search(now.begin(), now.end(), pair)) report(FLIPSIDE_END, pair);
    held_ = std::move(now);
    in_step_ = false;
}

bool Space::control(const flipside_control& control) {
    switch (control.kind) {
        case FLIPSIDE_ADD_BALL:
            add_ball(control.ball);
            return true;
        case FLIPSIDE_REMOVE_BALL:
            remove_ball(control.ball.state.number);
            return true;
        case FLIPSIDE_SET_BALL:
            remove_ball(control.ball.state.number);
            add_ball(control.ball);
            return true;
        case FLIPSIDE_NUDGE:
            for (const auto& [number, ball] : balls_)
                cpBodySetVelocity(ball.body, cpvadd(cpBodyGetVelocity(ball.body), vec(control.velocity)));
            return true;
        case FLIPSIDE_PRESENCE: {
            std::vector<cpShape*>& shapes = parts_[control.part].shapes;
            if (control.on != 0) return false;  // its shapes are not here any more
            std::erase_if(held_,
                          [&](const Pair& pair) { return !pair.with_ball && pair.other == control.part; });
            for (cpShape* shape : std::exchange(shapes, {})) {
                cpSpaceRemoveShape(space_.get(), shape);
                cpShapeFree(shape);
            }
            return true;
        }
        default:
            return false;
    }
}

}  // namespace flipside_chipmunk

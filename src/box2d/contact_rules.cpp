#include "box2d/contact_rules.hpp"

#include <algorithm>
#include <tuple>

namespace flipside::box2d {

namespace {

auto pair_of(const Impact& impact) {
    return std::tuple(impact.ball, impact.other);
}

void sort_by_pair(std::vector<Impact>& impacts) {
    // Not stable_sort, which allocates; rows that tie are told apart by what they say.
    std::ranges::sort(impacts, std::less{}, [](const Impact& i) {
        return std::tuple(i.ball, i.other, -i.speed, -i.impulse, i.point.x, i.point.y);
    });
}

}  // namespace

const Ball& ContactRules::ball_of(b2Fixture& fixture) const {
    return balls_[fixture.GetBody()->GetUserData().pointer];
}

bool ContactRules::ShouldCollide(b2Fixture* a, b2Fixture* b) {
    const Other owner_a = Tag::of(*a).owner, owner_b = Tag::of(*b).owner;
    if (owner_a.is_ball && owner_b.is_ball) return layers_meet(ball_of(*a), ball_of(*b));
    const Ball& ball = ball_of(owner_a.is_ball ? *a : *b);
    return layers_meet(ball, table_.scene().parts[owner_a.is_ball ? owner_b.index : owner_a.index]);
}

bool passes_gate(const Table& table, PartIndex part, Ball ball, Vec2 center, Vec2 velocity) {
    ball.position = center;
    ball.velocity = velocity;
    return table.lets_through(part, table.pose(part), table.rate(part), ball);
}

/// Whether the gate lets a ball through that touches it; notes what was decided.
bool ContactRules::meets_gate(const Meeting& meeting, double approach) {
    const PartIndex part = meeting.other.index;
    const b2Body& body = *meeting.ball.GetBody();
    const Ball& ball = ball_of(meeting.ball);
    if (!passes_gate(table_, part, ball, units_.point(body.GetPosition()),
                     units_.vector(body.GetLinearVelocity()))) {
        table_.set_blocked(part, ball.number, true);
        return false;
    }
    if (approach > 0) open_gate(part, *meeting.surface.GetBody());
    return true;
}

void ContactRules::open_gate(PartIndex part, const b2Body& gate) {
    if (table_.parts()[part].open) return;
    table_.set_open(part, true);
    std::erase_if(table_.blocked(), [&](const Blocked& blocked) { return blocked.gate == part; });
    // What lies against its other side now falls through it.
    for (const b2ContactEdge* edge = gate.GetContactList(); edge; edge = edge->next)
        if (edge->contact->IsTouching()) edge->other->SetAwake(true);
}

void ContactRules::PreSolve(b2Contact* contact, const b2Manifold*) {
    const Meeting meeting = Meeting::of(*contact);
    const auto touch = touch_of(*contact, meeting, *contact->GetManifold());
    if (!touch) {
        if (trace_) trace_->passed_over(meeting, "apart, or at a joint");
        return contact->SetEnabled(false);
    }

    const Vec2 normal = unit({touch->normal.x, touch->normal.y});
    const Vec2 velocity =
        units_.vector(meeting.ball.GetBody()->GetLinearVelocityFromWorldPoint(touch->point) -
                      meeting.surface.GetBody()->GetLinearVelocityFromWorldPoint(touch->point));
    const Scene& scene = table_.scene();
    const bool on_part = !meeting.other.is_ball;
    const double approach = -dot(velocity, normal);
    if (on_part && gate_of(scene.parts[meeting.other.index]) && meets_gate(meeting, approach)) {
        if (trace_) trace_->passed_over(meeting, "the gate lets it through");
        return contact->SetEnabled(false);
    }

    const Material& material = scene.materials[ball_of(meeting.ball).material];
    const Material& others = scene.materials[on_part ? scene.parts[meeting.other.index].material
                                                     : ball_of(meeting.surface).material];
    const Mixed mixed = mix(material, others);
    // The velocities already hold the whole sub-step's gravity. A ball that lies on a part approaches it
    // by that much in every step, which is rest, not an impact. (Two balls fall alike.)
    const double weight = on_part ? std::max(0.0, -dot(scene.gravity, normal)) * substep_ : 0;
    double restitution = 0;
    if (approach > scene.rest_speed + weight) {
        // Box2D turns a normal speed v into e·v, so this e gives at least the kick.
        restitution = std::max(mixed.restitution, mixed.kick / approach);
        const Vec2 surface = units_.point(touch->point) - units_.distance(touch->separation) / 2 * normal;
        approaches_.push_back({meeting.number, meeting.other, surface, normal, approach});
    }
    if (trace_)
        trace_->before_solve(meeting, units_.point(touch->point), normal, units_.distance(touch->separation),
                             approach, restitution, mixed.friction);
    contact->SetRestitution(static_cast<float>(restitution));
    contact->SetRestitutionThreshold(0);
    contact->SetFriction(static_cast<float>(mixed.friction));
}

void ContactRules::PostSolve(b2Contact* contact, const b2ContactImpulse* impulse) {
    const Meeting meeting = Meeting::of(*contact);
    solved_.push_back(
        {meeting.number, meeting.other, {}, {}, 0, units_.distance(impulse->normalImpulses[0])});
    if (trace_)
        trace_->after_solve(meeting, units_.distance(impulse->normalImpulses[0]),
                            units_.distance(impulse->tangentImpulses[0]));
}

void ContactRules::clear() {
    approaches_.clear();
    solved_.clear();
}

const std::vector<Impact>& ContactRules::impacts() {
    sort_by_pair(approaches_);
    sort_by_pair(solved_);
    impacts_.clear();
    auto next = solved_.begin();
    for (const Impact& approach : approaches_) {
        if (!impacts_.empty() && pair_of(impacts_.back()) == pair_of(approach)) continue;
        Impact impact = approach;
        while (next != solved_.end() && pair_of(*next) < pair_of(impact)) ++next;
        for (; next != solved_.end() && pair_of(*next) == pair_of(impact); ++next)
            impact.impulse += next->impulse;
        if (impact.impulse > 0) impacts_.push_back(impact);
    }
    return impacts_;
}

}  // namespace flipside::box2d

/// One step of a Box2D world: launches, sub-steps, and the report of what they did.

#include <algorithm>

#include "box2d/misfit.hpp"
#include "box2d/world.hpp"

namespace flipside::box2d {

namespace {

constexpr std::string_view stages[] = {"collide",         "solver set-up", "velocity solver",
                                       "position solver", "broad phase",   "time of impact"};

/// `list` is sorted by ball, then other, as contacts are.
const Contact* find(const std::vector<Contact>& list, const Contact& pair) {
    const auto key = [](const Contact& c) { return std::pair(c.ball, c.other); };
    const auto at = std::ranges::lower_bound(list, key(pair), {}, key);
    return at != list.end() && key(*at) == key(pair) ? &*at : nullptr;
}

}  // namespace

void Box2dWorld::step(double dt) {
    guard_.run(
        table_, balls_, [&] { make_step(dt); }, [&](const State& before) { restore(before); });
}

void Box2dWorld::make_step(double dt) {
    events_.clear();
    statistics_ = uncounted();
    if (trace_) trace_->stages.clear();
    for (std::size_t i = 0; i < std::size(stages); ++i) statistics_.stages[i].name = stages[i];
    rules_.clear();
    launch();
    const int n = options_.substeps;
    for (int i = 0; i < n; ++i) substep(dt * i / n, dt * (i + 1) / n);
    table_.advance(dt);
    read_back();
    enter_gates();
    report_impacts();
    report_touches();
    report_lost();
    for (Event& event : events_) {
        event.time = table_.time();
        require_finite("box2d", event, table_.scene());
    }
    measure();
    if (trace_) trace_read_out(*trace_, "src/box2d/step.cpp: Box2dWorld::read_back", *this, table_.scene());
}

void Box2dWorld::launch() {
    while (const auto launched = table_.launch(balls_)) {
        if (const auto found = misfit(launched->ball, units_))
            throw Refusal("box2d: the " + std::string(found->key) + " of a launched ball " + found->problem);
        if (!launched->existing) {
            balls_.push_back(table_.numbered(launched->ball));
            add_body(balls_.back());
            continue;
        }
        const std::size_t place = place_of(launched->ball.number);
        balls_[place] = launched->ball;
        bodies_[place]->SetLinearVelocity(units_.vector(launched->ball.velocity));
    }
}

/// `from` and `to` are seconds since the start of the step.
void Box2dWorld::substep(double from, double to) {
    const double h = to - from;
    for (const PartIndex part : moving_) {
        const double turn = table_.pose(part, to).angle - table_.pose(part, from).angle;
        parts_[part]->SetAngularVelocity(static_cast<float>(turn / h));
    }
    std::optional<StepTrace> traced;
    if (trace_) traced.emplace(*trace_, table_.scene(), units_, bodies_);
    fall(h);
    if (traced) traced->fell(bodies_, balls_, *world_, h, ahead_);
    rules_.write_to(traced ? &*traced : nullptr);
    before_.clear();
    for (const b2Body* body : bodies_) before_.push_back(body->GetPosition());

    rules_.begin_substep(h);
    world_->Step(static_cast<float>(h), options_.velocity_iterations, options_.position_iterations);

    rules_.write_to(nullptr);
    if (traced) traced->finish(bodies_, balls_, *world_, h);
    fall_after(h);
    if (traced && options_.verlet) traced->fell_after(bodies_, balls_, h);

    // Box2D turned the moving parts by sums of floats; put them where they are to be.
    for (const PartIndex part : moving_)
        if (parts_[part]->GetAngularVelocity() != 0)
            parts_[part]->SetTransform(parts_[part]->GetPosition(),
                                       static_cast<float>(table_.pose(part, to).angle));
    touching_.look(*world_, table_, balls_, units_, before_);
    looked_ = true;
    leave_gates();
    report_sensors();

    const b2Profile& profile = world_->GetProfile();
    const float milliseconds[] = {profile.collide,       profile.solveInit,  profile.solveVelocity,
                                  profile.solvePosition, profile.broadphase, profile.solveTOI};
    for (std::size_t i = 0; i < std::size(stages); ++i)
        statistics_.stages[i].seconds += 1e-3 * double{milliseconds[i]};
    statistics_.narrow_tests += touching_.pairs;
    statistics_.contacts += touching_.contacts.size();
}

/// Gates that no ball touches any more close, and those forget a ball that they blocked and that has left.
void Box2dWorld::leave_gates() {
    const auto& at_gates = touching_.at_gates;
    for (const PartIndex gate : gates_)
        if (std::ranges::find(at_gates, gate, &BallOnPart::part) == at_gates.end())
            table_.set_open(gate, false);
    std::erase_if(table_.blocked(), [&](const Blocked& blocked) {
        return !std::ranges::binary_search(at_gates, BallOnPart{blocked.ball, blocked.gate});
    });
}

/// The solver decides about a gate where a ball makes contact with it, and a fast ball can be moved deep into
/// one without a contact. It is decided here then, as it would be at the next one: a state that is saved now
/// says all that a restored world needs.
void Box2dWorld::enter_gates() {
    for (const BallOnPart& at : touching_.at_gates) {
        const Ball& ball = balls_[place_of(at.ball)];
        if (table_.parts()[at.part].open || !begins_in_gate(at.part, ball)) continue;
        if (table_.lets_through(at.part, table_.pose(at.part), table_.rate(at.part), ball))
            rules_.open_gate(at.part, *parts_[at.part]);
        else
            table_.set_blocked(at.part, at.ball, true);
        looked_ = false;
    }
}

/// Gravity and damping over `h`, by Box2D's own formula v ← (v + h·g)/(1 + h·c).
void Box2dWorld::gain(b2Body& body, double h) {
    const Scene& scene = table_.scene();
    const Vec2 v = units_.vector(body.GetLinearVelocity());
    const Vec2 change = (v + h * scene.gravity) / (1 + h * scene.damping) - v;
    body.ApplyLinearImpulseToCenter(body.GetMass() * units_.vector(change), false);
}

/// Ahead of Box2D's step, so that the velocities that ContactRules sees are those that the solver starts
/// from. By the integrator "verlet" what flies gets half of it now, and half in fall_after(); what lies on
/// something keeps all of it before the solver, which holds the ball against it.
void Box2dWorld::fall(double h) {
    ahead_.assign(bodies_.size(), h);
    if (options_.verlet) {
        look();
        std::ranges::fill(ahead_, h / 2);
        for (const Contact& contact : touching_.contacts) {
            ahead_[place_of(contact.ball)] = h;
            if (contact.other.is_ball) ahead_[place_of(contact.other.index)] = h;
        }
    }
    for (std::size_t i = 0; i < bodies_.size(); ++i)
        if (bodies_[i]->IsAwake()) gain(*bodies_[i], ahead_[i]);
}

void Box2dWorld::fall_after(double h) {
    for (std::size_t i = 0; i < bodies_.size(); ++i)
        if (ahead_[i] < h && bodies_[i]->IsAwake()) gain(*bodies_[i], h - ahead_[i]);
}

void Box2dWorld::read_back() {
    for (std::size_t i = 0; i < balls_.size(); ++i) {
        Ball& ball = balls_[i];
        const b2Body& body = *bodies_[i];
        const bool asleep = !body.IsAwake();
        if (asleep && ball.asleep) continue;
        ball.position = units_.point(body.GetPosition());
        ball.velocity = units_.vector(body.GetLinearVelocity());
        ball.angle = double{body.GetAngle()};
        ball.spin = double{body.GetAngularVelocity()};
        ball.asleep = asleep;
    }
}

void Box2dWorld::report(EventKind kind, const Contact& contact) {
    events_.push_back({0, kind, contact.ball, contact.other, contact.point, contact.normal, 0, 0});
}

void Box2dWorld::report_sensors() {
    const auto pair = [](const BallOnPart& b) { return Contact{b.ball, Other::part(b.part), {}, {}, 0}; };
    const auto on = [](const std::vector<BallOnPart>& list, const BallOnPart& b) {
        return std::ranges::binary_search(list, b);
    };
    for (const BallOnPart& b : touching_.sensors)
        if (!on(on_sensors_, b)) report(EventKind::sensor_begin, pair(b));
    for (const BallOnPart& b : touching_.passed) {
        if (on(on_sensors_, b) || on(touching_.sensors, b)) continue;
        report(EventKind::sensor_begin, pair(b));
        report(EventKind::sensor_end, pair(b));
    }
    for (const BallOnPart& b : on_sensors_)
        if (!on(touching_.sensors, b)) report(EventKind::sensor_end, pair(b));
    on_sensors_ = touching_.sensors;
}

void Box2dWorld::report_impacts() {
    for (const Impact& impact : rules_.impacts()) {
        events_.push_back({0, EventKind::impact, impact.ball, impact.other, impact.point, impact.normal,
                           impact.speed, impact.impulse});
        ++statistics_.impacts;
        if (impact.other.is_ball || !table_.scene().parts[impact.other.index].target) continue;
        table_.set_down(impact.other.index, true);
        parts_[impact.other.index]->SetEnabled(false);
        looked_ = false;
    }
}

/// Whether a ball moves towards what it touches or away from it, as in a bounce.
bool Box2dWorld::comes_or_goes(const Contact& contact) const {
    Vec2 velocity = balls_[place_of(contact.ball)].velocity;
    if (contact.other.is_ball) {
        velocity -= balls_[place_of(contact.other.index)].velocity;
    } else {
        const PartIndex part = contact.other.index;
        velocity -= cross(table_.rate(part), contact.point - table_.pose(part).pivot);
    }
    return std::abs(dot(velocity, contact.normal)) > table_.scene().rest_speed;
}

/// A touch begins when a ball is there at the end of the step and neither comes nor goes; it ends when they
/// no longer touch.
void Box2dWorld::report_touches() {
    look();
    still_held_.clear();
    for (const Contact& contact : touching_.contacts) {
        const bool begun = find(held_, contact) != nullptr;
        if (!begun && comes_or_goes(contact)) continue;
        if (!begun) report(EventKind::begin, contact);
        still_held_.push_back(contact);
    }
    for (const Contact& contact : held_)
        if (!find(still_held_, contact)) report(EventKind::end, contact);
    held_.swap(still_held_);
}

void Box2dWorld::report_lost() {
    const Scene& scene = table_.scene();
    table_.report_lost(balls_, events_);
    for (std::size_t i = scene.keep_lost ? balls_.size() : 0; i < balls_.size();) {
        if (scene.bounds.contains(balls_[i].position)) {
            ++i;
        } else {
            remove_at(i);
            looked_ = false;
        }
    }
}

void Box2dWorld::measure() {
    look();
    statistics_.substeps = static_cast<std::uint64_t>(options_.substeps);
    statistics_.asleep = static_cast<std::uint64_t>(std::ranges::count(balls_, true, &Ball::asleep));
    // Box2D does not count the boxes it tests in its tree: pair_tests stays 0.
    statistics_.broad_phase.name = "dynamic tree";
    statistics_.broad_phase.levels = world_->GetTreeHeight();
    statistics_.broad_phase.leaves = world_->GetProxyCount();
    statistics_.broad_phase.nodes = std::max(0, 2 * world_->GetProxyCount() - 1);
}

}  // namespace flipside::box2d

#include "box2d/step_trace.hpp"

#include <algorithm>
#include <iterator>
#include <tuple>

#include <box2d/b2_contact.h>
#include <box2d/b2_fixture.h>

namespace flipside::box2d {

StepTrace::StepTrace(Trace& trace, const Scene& scene, const Units& units, std::span<b2Body* const> bodies)
    : trace_(trace), scene_(scene), units_(units) {
    for (const b2Body* body : bodies) before_.push_back({body->GetPosition(), body->GetLinearVelocity()});
}

StepTrace::FatBoxes StepTrace::fat_boxes(const b2World& world) {
    FatBoxes boxes;
    const b2BroadPhase& tree = world.GetContactManager().m_broadPhase;
    struct Collect {
        FatBoxes& boxes;
        const b2BroadPhase& tree;
        bool QueryCallback(int32 proxy) const {
            boxes[static_cast<const b2FixtureProxy*>(tree.GetUserData(proxy))->fixture] =
                tree.GetFatAABB(proxy);
            return true;
        }
    } collect{boxes, tree};
    tree.Query(&collect, {{-b2_maxFloat, -b2_maxFloat}, {b2_maxFloat, b2_maxFloat}});
    return boxes;
}

void StepTrace::fell(std::span<b2Body* const> bodies, std::span<const Ball> balls, const b2World& world,
                     double h, std::span<const double> ahead) {
    TraceStage& stage = trace_.stage("gravity and drag", "src/box2d/step.cpp: Box2dWorld::fall");
    std::size_t awake = 0;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        awake += bodies[i]->IsAwake();
        stage.add("velocity")
            .with("ball", balls[i].number)
            .with("position", units_.point(bodies[i]->GetPosition()))
            .with("velocity_before", units_.vector(before_[i].velocity))
            .with("velocity", units_.vector(bodies[i]->GetLinearVelocity()))
            .with("h", ahead[i])
            .with("formula", "v' = (v + h g) / (1 + h c)");
        before_[i].velocity = bodies[i]->GetLinearVelocity();
    }
    const auto flying =
        static_cast<std::size_t>(std::ranges::count_if(ahead, [h](double s) { return s < h; }));
    stage.says = "Balls that are awake get " + milliseconds(h) +
                 " of gravity and drag ahead of the solver: " + std::to_string(awake) + " of " +
                 std::to_string(bodies.size()) + "." +
                 (flying ? " Of them " + std::to_string(flying) + " in flight get half of it now." : "");
    ahead_.assign(ahead.begin(), ahead.end());
    boxes_ = fat_boxes(world);
    for (const b2Contact* contact = world.GetContactList(); contact; contact = contact->GetNext())
        pairs_.push_back(contact);
}

void StepTrace::fell_after(std::span<b2Body* const> bodies, std::span<const Ball> balls, double h) {
    TraceStage& stage =
        trace_.stage("gravity and drag, second half", "src/box2d/step.cpp: Box2dWorld::fall_after");
    for (std::size_t i = 0; i < bodies.size(); ++i)
        if (ahead_[i] < h && bodies[i]->IsAwake())
            stage.add("velocity")
                .with("ball", balls[i].number)
                .with("velocity", units_.vector(bodies[i]->GetLinearVelocity()))
                .with("h", h - ahead_[i])
                .with("formula", "v' = (v + h g) / (1 + h c)");
    stage.says = counted(stage.items.size(), "ball") +
                 " that touched nothing at the start: the half of gravity and drag that was left, so that "
                 "the flight is a parabola.";
}

bool StepTrace::at_start(const Meeting& meeting) const {
    b2Body& body = *meeting.ball.GetBody();
    return body.GetPosition() == before_[body.GetUserData().pointer].position;
}

TraceItem& StepTrace::add(const Meeting& meeting, const char* kind) {
    in_sub_steps_ = in_sub_steps_ || !at_start(meeting);
    TraceItem& item = (in_sub_steps_ ? sub_steps_ : contacts_).emplace_back(TraceItem{kind, {}});
    return item.with("ball", meeting.number).with_other(meeting.other, scene_);
}

void StepTrace::before_solve(const Meeting& meeting, Vec2 point, Vec2 normal, double separation,
                             double approach, double restitution, double friction) {
    TraceItem& item = add(meeting, "manifold");
    if (in_sub_steps_) add_sweep(item, meeting);
    item.with("point", point)
        .with("normal", normal)
        .with("separation", separation)
        .with("approach", approach)
        .with("restitution", restitution)
        .with("friction", friction);
}

/// In a sub-step the ball stands where it was advanced to, with the velocity that the solver gave it, so the
/// share of the step that it has flown is known; a push by the position solver is in it too.
void StepTrace::add_sweep(TraceItem& item, const Meeting& meeting) {
    b2Body& body = *meeting.ball.GetBody();
    const Vec2 from = units_.point(before_[body.GetUserData().pointer].position);
    const Vec2 to = units_.point(body.GetPosition()), velocity = units_.vector(body.GetLinearVelocity());
    item.with("position_before", from)
        .with("position", to)
        .with("velocity", velocity)
        .with("swept", swept(0, 1, [&](double share) { return from + share * (to - from); }));
    if (length_squared(velocity) > 0)
        item.with("time_of_impact", dot(to - from, velocity) / length_squared(velocity))
            .with("formula", "time of impact, from the start of the step = (p - p0) · v / v²");
}

void StepTrace::passed_over(const Meeting& meeting, const char* reason) {
    add(meeting, "passed over").with("reason", reason);
}

/// Box2D has moved the bodies by now, in a sub-step as in the step.
void StepTrace::after_solve(const Meeting& meeting, double normal_impulse, double tangential_impulse) {
    (in_sub_steps_ ? sub_steps_ : impulses_)
        .emplace_back(TraceItem{"impulse", {}})
        .with("ball", meeting.number)
        .with_other(meeting.other, scene_)
        .with("impulse", normal_impulse)
        .with("tangential_impulse", tangential_impulse);
}

void StepTrace::finish(std::span<b2Body* const> bodies, std::span<const Ball> balls, const b2World& world,
                       double h) {
    collide();
    solve_velocities(bodies, balls);
    solve_positions(bodies, balls, h);
    update_tree(bodies, balls, world);
    solve_times_of_impact();
}

void StepTrace::collide() {
    TraceStage& stage = trace_.stage("narrow phase (Collide)", "Box2D: b2ContactManager::Collide");
    stage.items = std::move(contacts_);
    stage.says = counted(pairs_.size(), "pair") + " of fat boxes overlap; " +
                 counted(stage.items.size(), "contact") + " of them touch and came to the listener.";
}

void StepTrace::solve_velocities(std::span<b2Body* const> bodies, std::span<const Ball> balls) {
    TraceStage& stage = trace_.stage("velocity solver", "Box2D: b2ContactSolver::SolveVelocityConstraints");
    stage.items = std::move(impulses_);
    const std::size_t impulses = stage.items.size();
    for (std::size_t i = 0; i < bodies.size(); ++i)
        stage.add("velocity")
            .with("ball", balls[i].number)
            .with("velocity_before", units_.vector(before_[i].velocity))
            .with("velocity", units_.vector(bodies[i]->GetLinearVelocity()));
    stage.says =
        counted(impulses, "contact") +
        " got impulses; velocities are those after the whole step. Islands, the order of contacts and "
        "single iterations are not visible from outside.";
}

void StepTrace::solve_positions(std::span<b2Body* const> bodies, std::span<const Ball> balls, double h) {
    TraceStage& stage = trace_.stage("position solver", "Box2D: b2ContactSolver::SolvePositionConstraints");
    double most = 0;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const Vec2 from = units_.point(before_[i].position), to = units_.point(bodies[i]->GetPosition());
        const Vec2 moved = h * units_.vector(bodies[i]->GetLinearVelocity());
        most = std::max(most, length(to - from - moved));
        stage.add("position")
            .with("ball", balls[i].number)
            .with("position_before", from)
            .with("position", to)
            .with("correction", to - from - moved)
            .with("formula", "p' = p + h v' + correction");
    }
    stage.says = "Balls move by h v' and are pushed apart: by " + brief(1e3 * most) +
                 " mm at most, in which time-of-impact sub-steps and rounding to float are not told apart.";
}

void StepTrace::update_tree(std::span<b2Body* const> bodies, std::span<const Ball> balls,
                            const b2World& world) {
    TraceStage& stage = trace_.stage("broad phase (dynamic tree)",
                                     "Box2D: b2BroadPhase::UpdatePairs, b2ContactManager::FindNewContacts");
    const FatBoxes now = fat_boxes(world);
    const b2BroadPhase& tree = world.GetContactManager().m_broadPhase;
    const auto box_of = [&](const b2AABB& box) {
        return Box{units_.point(box.lowerBound), units_.point(box.upperBound)};
    };
    std::size_t moved = 0, found = 0;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const b2Fixture* fixture = bodies[i]->GetFixtureList();
        const b2AABB &old = boxes_.at(fixture), &box = now.at(fixture);
        const bool renewed = !(old.lowerBound == box.lowerBound && old.upperBound == box.upperBound);
        moved += renewed;
        stage.add("fat box")
            .with("ball", balls[i].number)
            .with("box", box_of(box))
            .with("tight_box", box_of(fixture->GetAABB(0)))
            .with("renewed", renewed);
    }
    std::vector<TraceItem> of_parts;
    for (const auto& [fixture, box] : now) {
        const Other owner = Tag::of(*fixture).owner;
        if (owner.is_ball) continue;
        of_parts.emplace_back(TraceItem{"fat box", {}})
            .with_other(owner, scene_)
            .with("box", box_of(box))
            .with("tight_box", box_of(fixture->GetAABB(0)));
    }
    // The map has them by their addresses, which differ from run to run.
    std::ranges::sort(of_parts, {}, [](const TraceItem& item) {
        const Box& box = item.get<Box>("tight_box");
        return std::tuple(item.get<std::string>("part"), box.min.x, box.min.y, box.max.x, box.max.y);
    });
    std::ranges::move(of_parts, std::back_inserter(stage.items));
    stage.add("tree")
        .with("leaves", static_cast<std::int64_t>(tree.GetProxyCount()))
        .with("levels", static_cast<std::int64_t>(tree.GetTreeHeight()) + 1)
        .with("imbalance", static_cast<std::int64_t>(tree.GetTreeBalance()))
        .with("area_ratio", static_cast<double>(tree.GetTreeQuality()))
        .with("inner_nodes", "not visible from outside")
        .with("formula", "area ratio = sum of the perimeters of all nodes / perimeter of the root");
    for (b2Contact* contact = const_cast<b2Contact*>(world.GetContactList()); contact;
         contact = contact->GetNext()) {
        const bool is_new = std::ranges::find(pairs_, contact) == pairs_.end();
        const Meeting meeting = Meeting::of(*contact);
        stage.add("pair")
            .with("ball", meeting.number)
            .with_other(meeting.other, scene_)
            .with("new", is_new)
            .with("touching", contact->IsTouching());
        found += is_new;
    }
    stage.says =
        "Balls that left their fat boxes and were inserted anew: " + std::to_string(moved) + " of " +
        std::to_string(bodies.size()) + "; new pairs: " + std::to_string(found) + ". The tree has " +
        std::to_string(tree.GetProxyCount()) + " boxes as leaves, on " +
        counted(static_cast<std::uint64_t>(tree.GetTreeHeight()) + 1, "level") +
        "; its inner nodes are not visible from outside, and how many boxes were tested, Box2D does not "
        "count.";
}

void StepTrace::solve_times_of_impact() {
    TraceStage& stage = trace_.stage("time of impact", "Box2D: b2World::SolveTOI");
    stage.items = std::move(sub_steps_);
    stage.says = stage.items.empty()
                     ? "The listener saw no sub-step to a time of impact."
                     : counted(stage.items.size(), "call") +
                           " of the listener came from sub-steps to a time of impact; those times are not "
                           "visible from outside, but follow from how far the balls have come. Box2D goes "
                           "on until they overlap by some slops.";
}

}  // namespace flipside::box2d

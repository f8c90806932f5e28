#include "custom/simple/simple_solver.hpp"

#include <algorithm>

#include "custom/broad_phase/capacity.hpp"
#include "custom/engine.hpp"
#include "world/limits.hpp"

namespace flipside::custom {

SimpleSolver::SimpleSolver(Table& table, std::vector<Ball>& balls, const Layout& layout, BroadPhase& broad,
                           const SolverSettings& settings, StepRecord& record)
    : table_(table),
      scene_(table.scene()),
      balls_(balls),
      layout_(layout),
      broad_(broad),
      settings_(settings),
      record_(record) {}

void SimpleSolver::reserve(std::size_t balls) {
    reserve_for(started_, balls);
    reserve_for(moving_, layout_.size() + balls);
    reserve_for(pairs_, balls, pairs_per_ball);
}

void SimpleSolver::step(double dt) {
    const double duration = dt / settings_.motion_iterations;
    const TimeInterval interval(scene_.damping, duration);
    trace_ = record_.trace ? std::make_unique<SimpleTrace>(*record_.trace, table_, balls_, layout_, broad_)
                           : nullptr;
    auto& stages = record_.statistics.stages;
    Stopwatch watch;
    for (int motion = 1; motion <= settings_.motion_iterations; ++motion) {
        ahead_ = motion * duration;
        if (trace_) trace_->begin_motion(motion, settings_.motion_iterations);
        move_balls(interval);
        watch.lap(stages[1]);
        find_pairs();
        watch.lap(stages[0]);
        for (const PartIndex gate : layout_.gates()) decide_gate(gate, ahead_ - duration);
        if (trace_) trace_->decided_gates();
        for (int round = 1; round <= settings_.collision_iterations; ++round)
            if (!respond_to_pairs(duration, round)) break;
        watch_sensors();
        watch.lap(stages[2]);
        ++record_.statistics.substeps;
    }
    table_.advance(dt);
    table_.report_lost(balls_, record_.events);
    const auto lost = [&](const Ball& ball) { return !scene_.bounds.contains(ball.position); };
    if (!scene_.keep_lost) std::erase_if(balls_, lost);
}

void SimpleSolver::move_balls(const TimeInterval& interval) {
    started_.clear();
    for (Ball& ball : balls_) {
        started_.push_back(ball.position);
        ball.asleep = false;  // the other solver may have put it to sleep
        fly_freely(ball, scene_.gravity, interval);
    }
    if (trace_) trace_->moved(interval.time);
}

void SimpleSolver::find_pairs() {
    layout_.fill_proxies(table_, balls_, ahead_, 0, moving_);
    broad_.find_pairs(moving_, pairs_);
    if (trace_) trace_->found_pairs(moving_);
}

/// Decides for each ball that overlaps a gate whether the gate lets it through, by its position before it
/// moved, and keeps the gate open as long as such a ball overlaps it. The rule is in world/gate.hpp.
/// `before`: when the balls started to move.
void SimpleSolver::decide_gate(PartIndex part, double before) {
    const shape::Gate& gate = *gate_of(scene_.parts[part]);
    const Primitive line{primitive::Segment{gate.a, gate.b}, part};
    const Pose now = table_.pose(part, ahead_), started = table_.pose(part, before);
    const auto separation = [&](const Ball& ball) {
        ++record_.statistics.narrow_tests;
        return touch(ball.position, ball.radius, line, now).separation;
    };
    std::erase_if(table_.blocked(), [&](const Blocked& blocked) {
        if (blocked.gate != part) return false;
        const Ball* ball = find_ball(balls_, blocked.ball);
        return ball == nullptr || separation(*ball) > touch_distance * ball->radius;
    });
    bool occupied = false;
    for (const Pair pair : pairs_) {
        if (is_ball(pair.a) || layout_.primitive(pair.a).part != part) continue;
        Ball ball = balls_[index_of(pair.b)];
        if (separation(ball) >= 0) continue;
        ball.position = started_[index_of(pair.b)];
        if (table_.lets_through(part, started, table_.rate(part, before), ball) ||
            table_.is_deep_in(part, started, ball))
            occupied = true;
        else
            table_.set_blocked(part, ball.number, true);
    }
    table_.set_open(part, occupied);
    if (occupied) std::erase_if(table_.blocked(), [&](const Blocked& b) { return b.gate == part; });
}

/// One collision iteration: narrow phase and response of every pair, in order. Each response uses the results
/// of those before it. Returns whether any shapes overlapped.
bool SimpleSolver::respond_to_pairs(double duration, int round) {
    const Surroundings around{scene_.gravity, scene_.rest_speed, duration};
    if (trace_) trace_->begin_round(round, settings_.collision_iterations);
    bool any = false;
    for (const Pair pair : pairs_)
        any |= is_ball(pair.a) ? respond_to_ball(balls_[index_of(pair.a)], balls_[index_of(pair.b)], around)
                               : respond_to_primitive(balls_[index_of(pair.b)], pair.a, around);
    if (trace_) trace_->end_round();
    return any;
}

bool SimpleSolver::respond_to_primitive(Ball& ball, PrimitiveIndex index, const Surroundings& around) {
    const Primitive& primitive = layout_.primitive(index);
    const auto [pose, rate, until_stop] = table_.turning(primitive.part, ahead_);
    const bool collides = layout_.should_collide(table_, index, pose, ball);
    if (trace_ && !collides) trace_->passed_over(ball, index);
    if (!collides) return false;
    ++record_.statistics.narrow_tests;
    const Touch found = touch(ball.position, ball.radius, primitive, pose);
    if (trace_) trace_->tested(ball, index, pose, found);
    if (found.separation >= -overlap_slop * ball.radius || found.past_end) return false;
    ++record_.statistics.contacts;
    const Vec2 surface_velocity = cross(rate, found.point - pose.pivot);
    const Part& part = scene_.parts[primitive.part];
    const Impact impact = respond(ball, found, surface_velocity, layout_.mixed(ball, part), around);
    push_out(ball, found);
    if (trace_) trace_->responded(ball, index, surface_velocity, impact, layout_.mixed(ball, part));
    if (impact.happened) {
        report(ball, Other::part(primitive.part), impact, found.point);
        if (part.target) table_.set_down(primitive.part, true);
    }
    return true;
}

bool SimpleSolver::respond_to_ball(Ball& lower, Ball& upper, const Surroundings& around) {
    ++record_.statistics.narrow_tests;
    const Touch found = touch(lower.position, lower.radius, upper.position, upper.radius);
    if (trace_) trace_->tested(lower, upper, found);
    if (found.separation >= -overlap_slop * std::min(lower.radius, upper.radius)) return false;
    ++record_.statistics.contacts;
    const Impact impact = respond(lower, upper, layout_.mixed(lower, upper), around);
    push_out(lower, upper, found);
    if (trace_) trace_->responded(lower, upper, impact, layout_.mixed(lower, upper));
    if (impact.happened) report(lower, Other::ball(upper.number), impact, found.point);
    return true;
}

void SimpleSolver::report(const Ball& ball, Other other, const Impact& impact, Vec2 point) {
    ++record_.statistics.impacts;
    const double time = table_.time() + ahead_;
    if (!within_top_speed(ball)) refuse_speed(engine_name, ball, other, time, scene_);
    record_.events.push_back(
        {time, EventKind::impact, ball.number, other, point, impact.normal, impact.speed, impact.impulse});
}

/// Records overlaps with sensors. A ball that passes a sensor within one motion iteration is missed.
void SimpleSolver::watch_sensors() {
    if (trace_) trace_->begin_sensors();
    for (const Pair pair : pairs_) {
        if (is_ball(pair.a)) continue;
        const Primitive& primitive = layout_.primitive(pair.a);
        if (!scene_.parts[primitive.part].sensor) continue;
        const Ball& ball = balls_[index_of(pair.b)];
        ++record_.statistics.narrow_tests;
        const Pose pose = table_.pose(primitive.part, ahead_);
        const double separation = touch(ball.position, ball.radius, primitive, pose).separation;
        if (trace_) trace_->sensed(ball, pair.a, separation);
        if (separation <= 0) record_.crossed.push_back({ball.number, primitive.part});
    }
}

}  // namespace flipside::custom

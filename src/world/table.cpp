#include "world/table.hpp"

#include <algorithm>

#include "world/gate.hpp"
#include "world/refusal.hpp"
#include "world/surface.hpp"

namespace flipside {

namespace {

constexpr double never = std::numeric_limits<double>::infinity();

const shape::Flipper& flipper_of(const Part& part) {
    return std::get<shape::Flipper>(part.shape.is);
}

constexpr std::uint32_t nothing = ~0U;

}  // namespace

double next_look(double time) {
    constexpr double looks_per_second = 240;
    return (std::floor((time + same_moment) * looks_per_second) + 1) / looks_per_second;
}

Table::Table(std::shared_ptr<const Scene> scene) : scene_(std::move(scene)) {
    state_.next_number = static_cast<BallNumber>(scene_->balls.size());
    state_.parts.resize(scene_->parts.size());
    // Memory for all balls that come to a gate at a time, so that no step has to ask for it.
    constexpr std::size_t balls_at_a_gate = 64;
    const auto is_gate = [](const Part& part) { return std::holds_alternative<shape::Gate>(part.shape.is); };
    state_.blocked.reserve(balls_at_a_gate *
                           static_cast<std::size_t>(std::ranges::count_if(scene_->parts, is_gate)));
    drive_of_.assign(scene_->parts.size(), nothing);
    for (PartIndex i = 0; i < scene_->parts.size(); ++i) {
        const Part& part = scene_->parts[i];
        if (!moves(part)) continue;
        drive_of_[i] = static_cast<std::uint32_t>(moving_.size());
        moving_.push_back(i);
        if (const auto* turn = std::get_if<motion::Turn>(&part.motion))
            drives_.push_back({turn->pivot, false, turn->always, 0, 0, turn->rate, 0});
        else if (const auto* flip = std::get_if<motion::Flip>(&part.motion))
            drives_.push_back({flipper_of(part).pivot, true, false, static_cast<int>(flip->side),
                               flip->raised - flipper_of(part).rest, flip->up_rate, flip->down_rate});
    }
}

void Table::apply(const Control& control) {
    struct Apply {
        State& state;
        const Scene& scene;
        void operator()(const control::Flip& c) const { state.raised[static_cast<int>(c.side)] = c.up; }
        void operator()(const control::Launch& c) const {
            if (!scene.launcher || c.count <= 0) return;
            if (state.launches.empty()) state.next_look = state.clock.time;
            state.launches.push_back(c);
        }
        void operator()(const control::Nudge&) const {}
        void operator()(const control::Rotate& c) const { state.rotating = c.on; }
        void operator()(const control::RaiseTargets& c) const {
            if (c.parts.empty())
                for (PartState& part : state.parts) part.down = false;
            for (const PartIndex part : c.parts) state.parts[part].down = false;
        }
    };
    std::visit(Apply{state_, *scene_}, control);
}

Table::Turning Table::turning(PartIndex part, double ahead) const {
    const double angle = state_.parts[part].angle;
    if (drive_of_[part] == nothing) return {{{}, angle}, 0, never};
    const Drive& drive = drives_[drive_of_[part]];
    if (!drive.flips) {
        const double rate = drive.always || state_.rotating ? drive.rate : 0;
        return {{drive.pivot, angle + rate * ahead}, rate, never};
    }
    const bool up = state_.raised[drive.side];
    const double goal = up ? drive.full : 0;
    if (angle == goal) return {{drive.pivot, goal}, 0, never};
    const double speed = up ? drive.rate : drive.down_rate;
    const double until_stop = std::abs(goal - angle) / speed;
    if (ahead >= until_stop) return {{drive.pivot, goal}, 0, never};
    const double rate = goal > angle ? speed : -speed;
    return {{drive.pivot, angle + rate * ahead}, rate, until_stop - ahead};
}

Pose Table::pose(PartIndex part, double ahead) const {
    return turning(part, ahead).pose;
}

double Table::rate(PartIndex part, double ahead) const {
    return turning(part, ahead).rate;
}

double Table::until_stop(PartIndex part) const {
    return turning(part, 0).until_stop;
}

void Table::advance(double dt) {
    for (const PartIndex i : moving_) state_.parts[i].angle = turning(i, dt).pose.angle;
    state_.clock.advance(dt);
}

void Table::set_to(const Clock& clock, std::span<const PartState> start, double ahead) {
    for (const PartIndex i : moving_) {
        state_.parts[i].angle = start[i].angle;
        state_.parts[i].angle = turning(i, ahead).pose.angle;
    }
    state_.clock = clock;
    state_.memory.time = clock.time;
}

std::optional<Table::Launched> Table::launch(std::span<const Ball> balls) {
    if (state_.launches.empty() || time() < state_.next_look - same_moment) return std::nullopt;
    control::Launch& next = state_.launches.front();
    const Launcher& launcher = *scene_->launcher;
    Launched launched{launcher.ball, false};
    Ball& ball = launched.ball;
    ball.radius *= next.size;
    ball.mass *= next.size * next.size * next.size;
    ball.position = launcher.position;
    const double speed = launcher.slowest + next.strength * (launcher.fastest - launcher.slowest);
    ball.velocity = speed * launcher.direction;

    const auto distance = [&](const Ball& other) { return length(other.position - launcher.position); };
    const auto lies_there = [&](const Ball& other) {
        return distance(other) < ball.radius && dot(other.velocity, launcher.direction) < 0.5 * speed;
    };
    // Balls launched one after another keep a gap of one radius, but for rounding.
    constexpr double but_for_rounding = 1 - 1e-9;
    const auto in_the_way = [&](const Ball& other) {
        return distance(other) < but_for_rounding * (other.radius + 2 * ball.radius);
    };
    if (const auto lying = std::ranges::find_if(balls, lies_there);
        launcher.plunger && lying != balls.end()) {
        launched = {*lying, true};
        launched.ball.velocity = speed * launcher.direction;
        launched.ball.asleep = false;
    } else if (std::ranges::any_of(balls, in_the_way)) {
        state_.next_look = next_look(time());
        return std::nullopt;
    }
    if (--next.count <= 0) state_.launches.erase(state_.launches.begin());
    if (state_.launches.empty()) state_.next_look = 0;
    return launched;
}

Ball Table::numbered(Ball ball) {
    if (state_.next_number == std::numeric_limits<BallNumber>::max())
        throw Refusal("no number is left for another ball; the last is " +
                      std::to_string(state_.next_number - 1));
    ball.number = state_.next_number++;
    return ball;
}

bool Table::is_blocked(PartIndex gate, BallNumber ball) const {
    return std::ranges::binary_search(state_.blocked, Blocked{gate, ball});
}

void Table::set_blocked(PartIndex gate, BallNumber ball, bool blocked) {
    set_listed(state_.blocked, {gate, ball}, blocked);
}

bool Table::lets_through(PartIndex gate, const Pose& pose, double rate, const Ball& ball) const {
    if (state_.parts[gate].open) return true;
    if (is_blocked(gate, ball.number)) return false;
    const Vec2 relative = ball.velocity - cross(rate, ball.position - pose.pivot);
    return flipside::lets_through(std::get<shape::Gate>(scene_->parts[gate].shape.is),
                                  pose.undo(ball.position), rotated(relative, -pose.angle), ball.radius);
}

bool Table::is_deep_in(PartIndex gate, const Pose& pose, const Ball& ball) const {
    return !is_blocked(gate, ball.number) &&
           begins_deep(*gate_of(scene_->parts[gate]), pose.undo(ball.position), ball.radius);
}

void Table::report_lost(std::span<const Ball> balls, std::vector<Event>& events) {
    std::vector<BallNumber>& reported = state_.reported_lost;
    for (const Ball& ball : balls) {
        if (scene_->bounds.contains(ball.position) ||
            std::ranges::find(reported, ball.number) != reported.end())
            continue;
        events.push_back({time(), EventKind::lost, ball.number, {}, ball.position, {}, 0, 0});
        if (scene_->keep_lost) reported.push_back(ball.number);
    }
}

State Table::save(std::span<const Ball> balls) const {
    State state = state_;
    state.balls.assign(balls.begin(), balls.end());
    forget_gone(state);
    return state;
}

void Table::forget_gone(State& state) {
    const auto gone = [&](BallNumber number) {
        return !std::ranges::binary_search(state.balls, number, {}, &Ball::number);
    };
    std::erase_if(state.blocked, [&](const Blocked& b) { return gone(b.ball) || state.parts[b.gate].open; });
    EngineMemory& memory = state.memory;
    if (memory.time != state.clock.time) memory = {};
    std::erase_if(memory.forces, [&](const ContactForce& f) { return gone(f.a) || gone(f.b); });
    std::erase_if(memory.inside, [&](const Sensed& sensed) { return gone(sensed.ball); });
}

void Table::restore(const State& state) {
    state_ = state;
    state_.balls.clear();
    state_.origin.reset();
}

}  // namespace flipside

// Changes of the world from outside: controls, balls that are launched, added and removed, saved states, and
// steps that are undone.

#include <algorithm>
#include <utility>

#include "custom/world.hpp"
#include "world/limits.hpp"

namespace flipside::custom {

/// Lists grow here, when balls are added, and hardly ever in a step.
void CustomWorld::reserve() {
    reserve_for(balls_, balls_.size() + 1);
    if (simple_) simple_->reserve(balls_.size());
    if (continuous_) continuous_->reserve(balls_.size());
    guard_.reserve(balls_.capacity(), std::max(least_capacity, balls_.capacity() * contacts_per_ball));
    contacts_.reserve(balls_.size());
    reserve_for(table_.memory().forces, balls_.size(), contacts_per_ball);
    reserve_for(table_.memory().inside, balls_.size(), touches_per_ball);
    reserve_for(table_.reported_lost(), balls_.size());
    reserve_for(table_.blocked(), balls_.size());
    reserve_for(record_.events, balls_.size(), events_per_ball);
    reserve_for(record_.crossed, balls_.size(), touches_per_ball);
}

BallNumber CustomWorld::append(const Ball& ball) {
    balls_.push_back(table_.numbered(ball));
    reserve();
    return balls_.back().number;
}

/// Launches the balls that are waiting for it.
void CustomWorld::launch() {
    while (const auto launched = table_.launch(balls_)) {
        interrupt();
        if (launched->existing)
            *std::ranges::lower_bound(balls_, launched->ball.number, {}, &Ball::number) = launched->ball;
        else
            append(launched->ball);
    }
}

void CustomWorld::wake_all() {
    for (Ball& ball : balls_) ball.asleep = false;
}

/// Prepares for a change of the world from outside.
void CustomWorld::interrupt() {
    if (continuous_) continuous_->interrupt();
}

void CustomWorld::apply(const Control& control) {
    find_contacts();
    interrupt();
    table_.apply(control);
    if (const auto* nudge = std::get_if<control::Nudge>(&control)) {
        wake_all();
        for (Ball& ball : balls_) ball.velocity += nudge->velocity;
    }
    if (std::holds_alternative<control::RaiseTargets>(control)) {
        wake_all();
        search_contacts();
    }
}

BallNumber CustomWorld::add(const Ball& ball) {
    find_contacts();
    interrupt();
    const BallNumber number = append(ball);
    search_contacts();
    contacts_.leave_sensors(number);
    return number;
}

bool CustomWorld::remove(BallNumber number) {
    const Ball* ball = find_ball(balls_, number);
    if (ball == nullptr) return false;
    find_contacts();
    interrupt();
    balls_.erase(balls_.begin() + (ball - balls_.data()));
    std::erase(table_.reported_lost(), number);
    std::erase_if(table_.memory().inside, [&](const Sensed& sensed) { return sensed.ball == number; });
    wake_all();
    search_contacts();
    return true;
}

State CustomWorld::save() const {
    State state = table_.save(balls_);
    if (continuous_) state.origin = continuous_->origin();
    return state;
}

void CustomWorld::restore(const State& state) {
    guard_.forget();
    reload([&] {
        if (resume(state)) return;
        load(state);
        if (continuous_) wake_restless();
    });
}

/// Wakes the sleeping balls of an edited state that cannot be at rest: those that move, and those that
/// nothing holds. Without gravity nothing needs to.
void CustomWorld::wake_restless() {
    for (Ball& ball : balls_) ball.asleep = ball.asleep && ball.velocity == Vec2{} && ball.spin == 0;
    if (scene_->gravity == Vec2{} || std::ranges::none_of(balls_, &Ball::asleep)) return;
    TouchList supports(layout_, table_, *broad_, sleep_distance);
    supports.search(balls_);
    supports.wake_unheld(balls_);
}

/// Replaces balls and table.
void CustomWorld::reload(auto&& how) {
    Trace* const trace = std::exchange(record_.trace, nullptr);  // restoring is not a step
    how();
    record_.events.clear();
    record_.statistics = {};
    search_contacts();
    fill_statistics(0);
    record_.trace = trace;
}

void CustomWorld::load(const State& state) {
    table_.restore(state);
    balls_ = state.balls;
    interrupt();
    if (continuous_) continuous_->load(balls_);
    reserve();
}

/// Runs the window in which the state was saved from its start. Returns false if this does not lead to the
/// state: another engine wrote it, or it was changed.
bool CustomWorld::resume(const State& state) {
    if (!state.origin || !continuous_) return false;
    load(*state.origin);
    if (!continuous_->resume(state.clock, balls_, record_)) return false;
    table_.look_at(state.next_look);  // looks of the launcher begin no window
    State reached = save();
    reached.origin = state.origin;
    return reached == state;
}

void CustomWorld::step(double dt) {
    if (record_.trace) record_.trace->stages.clear();
    if (continuous_) continuous_->keep();
    if (continuous_ && continuous_->can_undo() && !table_.launch_waiting()) return step_with_undo(dt);
    guard_.run(
        table_, balls_, [&] { make_step(dt); },
        [&](State before) {
            Table::forget_gone(before);
            if (continuous_) before.origin = continuous_->kept_origin();
            restore(before);
        });
}

/// Makes a step that starts in a window or in a quiet world. If it is refused, goes back to the start of the
/// window, and from there to the time before the step; in a quiet world only time has passed.
void CustomWorld::step_with_undo(double dt) {
    const Clock before = table_.clock();
    const bool quiet = continuous_->quiet();
    const auto make = [&] {
        make_step(dt);
        require_limits(engine_name, std::span(balls_).first(quiet ? 0 : balls_.size()), time());
    };
    const auto go_back = [&] {
        const auto origin = continuous_->kept_origin();
        if (!origin) return table_.set_to(before, table_.parts(), 0);
        load(*origin);
        continuous_->resume(before, balls_, record_);
    };
    guard_.attempt(make, [&] { reload(go_back); });
}

}  // namespace flipside::custom

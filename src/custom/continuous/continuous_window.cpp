#include <algorithm>
#include <functional>
#include <utility>

#include "custom/continuous/continuous_solver.hpp"

namespace flipside::custom {

void ContinuousSolver::begin(Table& table, std::span<const Ball> balls, double length, StepRecord& record) {
    table_ = &table, record_ = &record, dt_ = length, start_ = table.time();
    bodies_.assign(balls.begin(), balls.end());
    pending_.clear();
    part_forces_.clear(), ball_forces_.clear();
    creeping_.clear();
    events_ = search_steps_ = 0;
    paths_started_ = false;
    after_end_ = std::nextafter(dt_, INFINITY);
    any_in_island_ = false;
    for (const PartIndex i : table.moving_parts()) {
        const auto [pose, rate, stop] = table.turning(i, 0);
        const double end = std::isfinite(stop) ? table.pose(i, stop).angle : pose.angle;
        turnings_[i] = {pose, rate, stop, end};
    }
    assign_movers();
    settle_gates();
    current_ = 1 - kept_;
    table.copy(starts_[current_]);
    starts_[current_].balls = bodies_;
    any_awake_ = !std::ranges::all_of(bodies_, &Ball::asleep) ||
                 !std::ranges::all_of(turnings_, [](const Turning& turning) { return turning.still(); });
}

/// Assigns a mover to each ball, and clears what it holds of the ball that had it before.
void ContinuousSolver::assign_movers() {
    drop_lost();
    if (pool_.size() < bodies_.size()) reserve(bodies_.size());
    movers_ = std::span(pool_).first(bodies_.size());
    for (BallIndex i = 0; i < bodies_.size(); ++i) {
        Mover& mover = movers_[i];
        if (mover.number != bodies_[i].number) mover.candidates.forget();
        mover.number = bodies_[i].number;
        mover.jammed = mover.frozen = mover.on_tick_path = false;
        mover.resting_on = mover.separated_from = nullptr;
        mover.last_event = -1;
        mover.last_slow = mover.last_hit = -INFINITY;
        mover.simultaneous_events = mover.idle_events = mover.hits = 0;
        hot_[i] = {};
        hot_[i].radius = bodies_[i].radius;
    }
}

void ContinuousSolver::run(double until, StepRecord& record) {
    record_ = &record;
    if (!any_awake_) return;
    const bool starts = !paths_started_;
    if (starts) start_all_paths();
    if (record_->trace && (starts || record_->trace->stages.empty())) trace_paths(starts);
    handle_until(until);
}

void ContinuousSolver::start_all_paths() {
    paths_started_ = true;
    next_events_.reset(bodies_.size());
    cells_.reset(bodies_);
    for (BallIndex i = 0; i < bodies_.size(); ++i) {
        if (!bodies_[i].asleep) push_out_of_parts(i);
        start_path(i, 0);
    }
    find_islands();
    tick(0);
    members_.clear();
    for (BallIndex i = 0; i < bodies_.size(); ++i)
        if (!bodies_[i].asleep) members_.push_back(i);
    predict_together(members_, 0);
}

void ContinuousSolver::handle_until(double time) {
    for (;;) {
        const double event = next_events_.time();
        if (any_in_island_ && next_tick_ <= std::min(event, time) && next_tick_ < dt_) {
            tick(next_tick_);
            continue;
        }
        if (event > time || event > dt_) return;
        record_->trace ? trace_event(next_events_.first()) : handle(next_events_.first());
    }
}

/// The ball `time` seconds after the start of the window.
Ball ContinuousSolver::ball_at(BallIndex i, double time) const {
    const Mover& mover = movers_[i];
    Ball ball = bodies_[i];
    if (ball.asleep) return ball;
    if (hot_[i].in_island)
        advance_member(ball, mover, time);
    else
        advance(ball, mover.motion, time);
    return ball;
}

void ContinuousSolver::report_until(double time, double now) {
    auto kept = pending_.begin();
    for (Event& event : pending_) {
        if (event.time - start_ > time) {
            *kept++ = event;
            continue;
        }
        event.time = std::min(event.time, now);
        record_->events.push_back(event);
    }
    pending_.erase(kept, pending_.end());
}

void ContinuousSolver::read(double time, double now, std::vector<Ball>& balls) {
    balls.clear();
    read_at_ = time;
    for (BallIndex i = 0; i < movers_.size(); ++i) {
        rank_[i] = static_cast<BallIndex>(balls.size());
        if (!hot_[i].lost) balls.push_back(ball_at(i, time));
    }
    report_until(time, now);
}

void ContinuousSolver::end(double now, std::vector<Ball>& balls) {
    read(dt_, now, balls);
    report_until(INFINITY, now);
}

/// Moves the movers of lost balls to the end of the pool, where their lists keep their capacity.
void ContinuousSolver::drop_lost() {
    BallIndex kept = 0;
    for (BallIndex i = 0; i < movers_.size(); ++i) {
        if (hot_[i].lost) continue;
        if (kept != i) std::swap(movers_[kept], movers_[i]);
        ++kept;
    }
}

}  // namespace flipside::custom

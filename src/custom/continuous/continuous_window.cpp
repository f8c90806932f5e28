#include <algorithm>
#include <functional>
#include <utility>

#include "custom/continuous/continuous_solver.hpp"

namespace flipside::custom {

void ContinuousSolver::begin(Table& table, std::span<const Ball> balls, double length, StepRecord& record) {
    table_ = &table, record_ = &record, dt_ = length, start_ = table.time();
    bodies_.assign(balls.begin(), balls.end());
    pending_.clear();
    queue_.clear();
    // Certificates count from the end of a window.
    if (!std::exchange(ended_, false))
        for (Mover& mover : pool_) mover.free = 0;
    events_ = search_steps_ = 0;
    set_out_ = spoilt_ = false;
    if (stretch_.time != dt_) stretch_ = Stretch(drive_.drag, dt_);
    for (const PartIndex i : table.moving_parts()) {
        const auto [pose, rate, stop] = table.turning(i, 0);
        const double end = std::isfinite(stop) ? table.pose(i, stop).angle : pose.angle;
        Turning& turning = turnings_[i];
        parts_changed_ = parts_changed_ || rate != turning.rate || pose.angle != turning.begin.angle;
        turning = {pose, rate, stop, end};
    }
    take_places();  // which settles gates: a run made again begins from there
    table.copy(start_state_);
    start_state_.balls = bodies_;
    inside_before_ = inside_;
    find_active();
}

/// Gives each ball its mover. What was known of another ball is forgotten.
void ContinuousSolver::take_places() {
    if (pool_.size() < bodies_.size()) reserve(bodies_.size());
    movers_ = std::span(pool_).first(bodies_.size());
    if (paths_.size() != bodies_.size()) paths_.reset(bodies_.size());
    for (Place i = 0; i < bodies_.size(); ++i) {
        Mover& mover = movers_[i];
        if (mover.number != bodies_[i].number) {
            mover.near.forget();
            mover.lies = false;
            mover.free = 0;
            settled_ = false;
        }
        mover.number = bodies_[i].number;
        mover.handed_over = mover.lost = false;
    }
    if (!settled_) settle_gates(*table_, bodies_);
}

bool ContinuousSolver::run(double until, BroadPhase& broad, StepRecord& record) {
    record_ = &record;
    if (!any_active_) return true;
    const bool was_read = set_out_;
    if (was_read) note_flags();
    const std::uint64_t impacts = record.statistics.impacts;
    // Handing over spreads along touching balls, so a few attempts find a whole cluster.
    constexpr int most_attempts = 8;
    for (int attempts = 1;; ++attempts) {
        if (!set_out_) set_out_all(broad);
        handle_until(until);
        if (!spoilt_) break;
        restore_flags(was_read ? last_read_ : start_state_);
        record.statistics.impacts = impacts;
        if (was_read) return false;
        bodies_ = start_state_.balls;
        pending_.clear();
        set_out_ = spoilt_ = false;
        activate_all();
        if (attempts >= most_attempts)
            for (Mover& mover : movers_) mover.handed_over = true;
    }
    const auto handed = static_cast<std::uint64_t>(std::ranges::count_if(movers_, &Mover::handed_over));
    record.statistics.handed_over = std::max(record.statistics.handed_over, handed);
    return true;
}

void ContinuousSolver::set_out_all(BroadPhase& broad) {
    set_out_ = true;
    run_discrete(broad);
    prepare_movers();
    find_piles();
    if (spoilt_) return;
    for (const Place i : active_)
        if (!movers_[i].handed_over) predict(i, 0);
}

void ContinuousSolver::handle_until(double time) {
    while (!spoilt_ && !queue_.empty() && queue_.front().time <= time) {
        const Entry entry = queue_.front();
        std::ranges::pop_heap(queue_, std::greater{});
        queue_.pop_back();
        if (entry.prediction == movers_[entry.mover].predictions) handle(entry.mover);
    }
}

/// What events change beside balls, to be as before where a run has to be made again.
void ContinuousSolver::note_flags() {
    table_->copy(last_read_);
    inside_before_ = inside_;
}

void ContinuousSolver::restore_flags(const State& before) {
    inside_ = inside_before_;
    table_->pressings() = before.pressings;
    table_->blocked() = before.blocked;
    table_->reported_lost() = before.reported_lost;
    for (PartIndex i = 0; i < before.parts.size(); ++i) {
        table_->set_open(i, before.parts[i].open);
        table_->set_down(i, before.parts[i].down);
    }
}

/// The ball `time` seconds after the window's start.
Ball ContinuousSolver::ball_at(Place i, double time, const Stretch& since_start) const {
    const Mover& mover = movers_[i];
    Ball ball = bodies_[i];
    if (mover.handed_over) {
        if (time >= dt_) return ball;
        // Time-stepping knows the end of the window only.
        const Ball& before = start_state_.balls[i];
        const double part = time / dt_;
        ball.position = before.position + part * (ball.position - before.position);
        ball.velocity = before.velocity + part * (ball.velocity - before.velocity);
        ball.angle = before.angle + part * (ball.angle - before.angle);
        ball.spin = before.spin + part * (ball.spin - before.spin);
        ball.asleep = false;
    } else if (ball.asleep) {
        return ball;
    } else if (mover.active) {
        advance(ball, mover.way, time);
    } else {
        fly_freely(ball, drive_.gravity, since_start);
    }
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
    const Stretch since_start(drive_.drag, time);
    balls.clear();
    read_at_ = time;
    for (Place i = 0; i < movers_.size(); ++i) {
        rank_[i] = static_cast<Place>(balls.size());
        if (!movers_[i].lost) balls.push_back(ball_at(i, time, since_start));
    }
    report_until(time, now);
}

void ContinuousSolver::end(double now, std::vector<Ball>& balls) {
    for (Place i = 0; i < movers_.size(); ++i) {
        Mover& mover = movers_[i];
        if (mover.handed_over) settled_ = false;
        if (mover.lost) continue;
        bodies_[i] = ball_at(i, dt_, stretch_);
        mover.free -= dt_;
        mover.left_at = bodies_[i].position;
        mover.left_with = bodies_[i].velocity;
    }
    drop_lost();
    balls.assign(bodies_.begin(), bodies_.end());
    for (Place i = 0; i < movers_.size(); ++i) rank_[i] = i;
    report_until(INFINITY, now);
    read_at_ = dt_;
    ended_ = true;
}

/// Forgets the balls that were lost; the lists of their movers stay in the pool.
void ContinuousSolver::drop_lost() {
    if (std::ranges::none_of(movers_, &Mover::lost)) return;
    Place kept = 0;
    for (Place i = 0; i < movers_.size(); ++i) {
        if (movers_[i].lost) continue;
        if (kept != i) {
            bodies_[kept] = bodies_[i];
            std::swap(movers_[kept], movers_[i]);
            paths_.place(kept, paths_[i]);
        }
        ++kept;
    }
    bodies_.resize(kept);
    movers_ = movers_.first(kept);
    paths_.shrink(kept);
}

}  // namespace flipside::custom

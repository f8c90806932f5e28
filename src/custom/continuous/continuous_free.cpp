#include <algorithm>

#include "custom/continuous/continuous_solver.hpp"

namespace flipside::custom {

/// Finds who takes part in this step. A ball does not that surely flies free until its end, or that sleeps
/// where nothing turns. Any two who do not take part keep apart: the one who was found free later saw to it,
/// and when one falls asleep all are looked at again.
void ContinuousSolver::find_active() {
    const std::vector<Ball>& balls = bodies_;
    bool look_again = parts_changed_ && clearance_.follow(turnings_);
    parts_changed_ = false;
    for (Place i = 0; i < balls.size(); ++i) {
        const Ball& ball = balls[i];
        Mover& mover = movers_[i];
        const bool lies = ball.asleep && !clearance_.beside_turning(bounds_of(ball.position, ball.radius));
        look_again = look_again || (lies && !mover.lies);
        mover.lies = lies;
    }
    any_active_ = false;
    for (Place i = 0; i < balls.size(); ++i) {
        Mover& mover = movers_[i];
        mover.clear = false;
        if (look_again || mover.lies) mover.free = 0;
        mover.active = !mover.lies && !still_free(i);
    }
    list_active();
    for (const Place i : active_) {
        Mover& mover = movers_[i];
        if (!balls[i].asleep) find_free_time(i);
        if (mover.free >= dt_) mover.active = false;
        any_active_ = any_active_ || mover.active;
    }
}

/// Whether the certificate of a ball holds to the end of this step.
bool ContinuousSolver::still_free(Place i) const {
    const Mover& mover = movers_[i];
    const Ball& ball = bodies_[i];
    const bool is_there = ball.position == mover.left_at, is_so_fast = ball.velocity == mover.left_with;
    return (mover.free >= dt_) & is_there & is_so_fast;
}

void ContinuousSolver::find_free_time(Place i) {
    Mover& mover = movers_[i];
    const Ball& ball = bodies_[i];
    mover.clear = mover.free > 0 && ball.position == mover.left_at && ball.velocity == mover.left_with;
    mover.free = 0;
    const bool rested = mover.held != nullptr;
    // What cut the last certificate short is still ahead. Each is compared with all balls: among many that
    // costs more than it saves.
    constexpr std::size_t few = 64;
    if (settings_.look_ahead <= 0 || (mover.clear && mover.cut) || rested || bodies_.size() > few) return;
    if (std::ranges::any_of(inside_, [&](const Sensed& in) { return in.ball == ball.number; })) return;
    const double way = settings_.look_ahead * ball.radius;
    const double speed = length(ball.velocity) + std::sqrt(way * length(drive_.gravity));
    constexpr double fewest = 1, most = 64;  // steps
    const double longest = std::clamp(speed > 0 ? way / speed : INFINITY, fewest * dt_, most * dt_);
    const Flight flight{ball.position, ball.velocity, drive_.gravity, drive_.drag};
    Statistics& statistics = record_->statistics;
    const double free =
        clearance_.free_for(ball, flight, longest, dt_ / 2, statistics.pair_tests, statistics.narrow_tests);
    mover.clear = free > 0;
    if (free >= dt_) mover.free = free_of_balls(i, free);
    mover.cut = mover.free < longest;
}

/// Until when, at most, a ball in free flight stays clear of those who take no part.
double ContinuousSolver::free_of_balls(Place i, double until) const {
    const std::vector<Ball>& balls = bodies_;
    const Ball& a = balls[i];
    for (Place j = 0; j < balls.size(); ++j) {
        const Ball& b = balls[j];
        if (j == i || movers_[j].active || !layers_meet(a, b)) continue;
        const double reach = a.radius + b.radius + clearance_margin(a) + clearance_margin(b);
        const Vec2 between = a.position - b.position, closing = a.velocity - b.velocity;
        const double apart = length_squared(between) - reach * reach;
        if (apart <= 0) return 0;
        if (b.asleep) {
            const double distance = length(between);
            const double k = Flight{{}, a.velocity, drive_.gravity, drive_.drag}.max_acceleration(until);
            until = std::min(until, surely_free(distance - reach, dot(between, closing) / distance, k));
            continue;
        }
        // Seen from one another they fly straight, in a time that drag shrinks: never faster than the clock.
        const double approach = -dot(between, closing), speed_squared = length_squared(closing);
        if (approach <= 0) continue;
        const double inside = approach * approach - speed_squared * apart;
        if (inside < 0) continue;
        const double met = apart / (approach + std::sqrt(inside));
        if (met < movers_[j].free) until = std::min(until, met);
    }
    return until;
}

/// The way of a ball that takes no part, for those who may hit it.
void ContinuousSolver::go_free(Place i) {
    const Ball& ball = bodies_[i];
    Mover& mover = movers_[i];
    const bool asleep = ball.asleep;
    mover.way.until = never_touch;
    mover.way.spin_rate = 0;
    mover.way.roll = {};
    Path& path = mover.way.path;
    path.start = 0;
    path.swings = false;
    path.flight = {ball.position, ball.velocity, asleep ? Vec2{} : drive_.gravity, asleep ? 0 : drive_.drag};
    paths_.place(
        i, asleep ? bounds_of(ball.position, ball.radius) : grown(path.flight.bounds(stretch_), ball.radius));
}

void ContinuousSolver::activate_all() {
    any_active_ = true;
    for (Mover& mover : movers_) {
        mover.active = true;
        mover.clear = false;
        mover.free = 0;
    }
}

}  // namespace flipside::custom

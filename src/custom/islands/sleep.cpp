#include "custom/islands/sleep.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "custom/broad_phase/capacity.hpp"
#include "custom/tolerances.hpp"

namespace flipside::custom {

namespace {

/// Limits of speed and of its change for balls in contact, in units of the speed that gravity gives in the
/// interval. The second matters where gravity is so low that sleep_speed is the higher limit of speed.
constexpr double contact_speed = 1.0 / 60;
constexpr double contact_gain = 0.05;
/// A ball that gains more than this part of the speed that gravity gives in the interval has no support, nor
/// has one to which contacts give less than this part of it.
constexpr double falling = 0.5;
/// A ball wakes the sleeping balls that it touches if it is faster than the limit for rest by this factor.
/// Less keeps heaps awake: what has just woken is pushed by forces that are found anew.
constexpr double faster_to_wake = 4;

}  // namespace

void Sleep::reserve(std::size_t balls) {
    reserve_for(before_, balls);
    reserve_for(findings_, balls);
    reserve_for(carried_, balls, contacts_per_ball);
}

/// Speed below which a ball may be at rest, m/s.
double Sleep::speed_limit(bool touches_ball) const {
    return touches_ball ? std::max(speed_, contact_speed * length(gravity_) * interval_) : speed_;
}

void Sleep::watch(std::span<const Ball> balls, double interval) {
    interval_ = interval;
    before_.clear();
    const double most = speed_limit(true);
    std::ranges::copy_if(balls, std::back_inserter(before_), [&](const Ball& ball) {
        return !ball.asleep && length_squared(ball.velocity) <= most * most;
    });
}

bool Sleep::update(std::span<Ball> balls, std::span<const Contact> contacts) {
    find_rest(balls, contacts);
    find_sleepers(balls, contacts);
    bool any = false;
    for (std::size_t i = 0; i < balls.size(); ++i) {
        Ball& ball = balls[i];
        if (ball.asleep == findings_[i].may_sleep) continue;
        ball.asleep = findings_[i].may_sleep;
        any = true;
        if (!ball.asleep) continue;
        ball.velocity = {};
        ball.spin = 0;
    }
    return any;
}

/// Finds the balls that may sleep: those at rest that touch no moving ball and lie on no ball that stays
/// awake.
void Sleep::find_sleepers(std::span<const Ball> balls, std::span<const Contact> contacts) {
    carried_.clear();
    const double wake_speed = faster_to_wake * speed_limit(true);
    for (Finding& finding : findings_) finding.may_sleep = finding.at_rest;
    for (const Contact& contact : contacts) {
        if (!contact.other.is_ball) continue;
        const std::size_t a = index_of(balls, contact.ball), b = index_of(balls, contact.other.index);
        const auto disturbs = [&](std::size_t i, std::size_t other) {
            if (!balls[other].asleep) return !findings_[i].at_rest;
            return !balls[i].asleep && (findings_[i].squeezed || length(balls[i].velocity) > wake_speed);
        };
        findings_[a].may_sleep &= !disturbs(b, a);
        findings_[b].may_sleep &= !disturbs(a, b);
        const double lift = -dot(contact.normal, gravity_);
        if (lift == 0) continue;
        const std::size_t lower = lift > 0 ? b : a, upper = lift > 0 ? a : b;
        carried_.push_back({-dot(balls[lower].position, gravity_), lower, upper});
    }
    std::ranges::sort(carried_, {},
                      [](const Carried& pair) { return std::tuple(pair.height, pair.lower, pair.upper); });
    for (const Carried& pair : carried_) findings_[pair.upper].may_sleep &= findings_[pair.lower].may_sleep;
}

/// Finds the balls that were at rest during the interval.
void Sleep::find_rest(std::span<const Ball> balls, std::span<const Contact> contacts) {
    findings_.assign(balls.size(), {});
    for (const Contact& contact : contacts) {
        const auto note = [&](std::size_t i) {
            findings_[i].touches_ball |= contact.other.is_ball;
            findings_[i].squeezed |= -contact.separation > squeezed_overlap * balls[i].radius;
        };
        note(index_of(balls, contact.ball));
        if (contact.other.is_ball) note(index_of(balls, contact.other.index));
    }
    for (std::size_t i = 0; i < balls.size(); ++i) {
        Finding& finding = findings_[i];
        finding.at_rest = balls[i].asleep || (!finding.squeezed && rested(balls[i], finding.touches_ball));
    }
}

/// Whether an awake ball was at rest during the interval.
bool Sleep::rested(const Ball& ball, bool touches_ball) const {
    const Ball* const before = find_ball(before_, ball.number);
    if (before == nullptr) return false;
    const double fall = length(gravity_) * interval_;
    if (fall == 0) return ball.velocity == Vec2{} && before->velocity == Vec2{} && ball.spin == 0;
    const double slowest = speed_limit(touches_ball);
    const Vec2 moved = ball.position - before->position, gained = ball.velocity - before->velocity;
    // By all contacts, per mass: what gravity and drag do not explain.
    const Vec2 impulse = gained - interval_ * gravity_ + drag_ * moved;
    const double steady = touches_ball ? contact_gain * fall : 1e-3 * fall + 1e-2 * speed_;
    return length(ball.velocity) < slowest && length(before->velocity) < slowest &&
           std::abs(ball.spin) * ball.radius < slowest && length(moved) < slowest * interval_ &&
           length(gained) <= std::min(steady, falling * fall) && length(impulse) >= falling * fall;
}

}  // namespace flipside::custom

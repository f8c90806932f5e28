#include "custom/islands/sleep.hpp"

#include <algorithm>
#include <cmath>

#include "custom/broad_phase/capacity.hpp"
#include "custom/tolerances.hpp"

namespace flipside::custom {

namespace {

/// Of balls in touch: speeds and gains of speed that are rest, in units of what gravity gives in the moment.
constexpr double company_speed = 0.05;
constexpr double company_gain = 0.02;
/// A ball that gains more than this part of what gravity gives in the moment is not held.
constexpr double falling = 0.5;

std::size_t index_of(std::span<const Ball> balls, BallNumber number) {
    return static_cast<std::size_t>(std::ranges::lower_bound(balls, number, {}, &Ball::number) -
                                    balls.begin());
}

}  // namespace

void Sleep::reserve(std::size_t balls) {
    reserve_for(before_, balls);
    reserve_for(findings_, balls);
    reserve_for(carried_, balls, contacts_per_ball);
}

/// Below this a ball may be at rest, m/s.
double Sleep::slow(bool in_company) const {
    return in_company ? std::max(speed_, company_speed * length(gravity_) * moment_) : speed_;
}

/// False only of a ball that is surely not at rest.
bool Sleep::may_rest(const Ball& ball) const {
    const double most = slow(true);
    return !ball.asleep && length_squared(ball.velocity) <= most * most;
}

void Sleep::watch(std::span<const Ball> balls, double moment) {
    moment_ = moment;
    before_.clear();
    for (const Ball& ball : balls)
        if (may_rest(ball)) before_.push_back({ball.number, ball.position, ball.velocity});
}

bool Sleep::settle(std::span<Ball> balls, std::span<const Contact> contacts) {
    findings_.assign(balls.size(), {});
    find_company(balls, contacts);
    find_rest(balls);
    find_calm(balls, contacts);
    bool any = false;
    for (std::size_t i = 0; i < balls.size(); ++i) {
        Ball& ball = balls[i];
        if (ball.asleep == findings_[i].calm) continue;
        ball.asleep = findings_[i].calm;
        if (!ball.asleep) continue;
        any = true;
        ball.velocity = {};
        ball.spin = 0;
    }
    return any;
}

/// Of those at rest, the ones that touch no ball in motion and lie on none that stays awake.
void Sleep::find_calm(std::span<const Ball> balls, std::span<const Contact> contacts) {
    carried_.clear();
    for (Finding& finding : findings_) finding.calm = finding.at_rest;
    for (const Contact& contact : contacts) {
        if (!contact.other.is_ball) continue;
        const std::size_t a = index_of(balls, contact.ball), b = index_of(balls, contact.other.index);
        const auto disturbs = [&](std::size_t i, std::size_t other) {
            return balls[other].asleep ? !balls[i].asleep && findings_[i].squeezed : !findings_[i].at_rest;
        };
        findings_[a].calm &= !disturbs(b, a);
        findings_[b].calm &= !disturbs(a, b);
        const double lift = -dot(contact.normal, gravity_);
        if (lift == 0) continue;
        const std::size_t lower = lift > 0 ? b : a, upper = lift > 0 ? a : b;
        carried_.push_back({-dot(balls[lower].position, gravity_), static_cast<std::uint32_t>(lower),
                            static_cast<std::uint32_t>(upper)});
    }
    std::ranges::sort(carried_, {}, &Carried::height);
    for (const Carried& pair : carried_) findings_[pair.upper].calm &= findings_[pair.lower].calm;
}

void Sleep::find_company(std::span<const Ball> balls, std::span<const Contact> contacts) {
    for (const Contact& contact : contacts) {
        const auto note = [&](std::size_t i) {
            findings_[i].in_company |= contact.other.is_ball;
            findings_[i].squeezed |= -contact.separation > squeezed_overlap * balls[i].radius;
        };
        note(index_of(balls, contact.ball));
        if (contact.other.is_ball) note(index_of(balls, contact.other.index));
    }
}

void Sleep::find_rest(std::span<const Ball> balls) {
    auto before = before_.begin();
    for (std::size_t i = 0; i < balls.size(); ++i) {
        Finding& finding = findings_[i];
        finding.at_rest = balls[i].asleep;
        while (before != before_.end() && before->number < balls[i].number) ++before;
        if (before == before_.end() || before->number != balls[i].number || !may_rest(balls[i])) continue;
        finding.at_rest = !finding.squeezed && rested(*before, balls[i], finding.in_company);
    }
}

/// Whether a ball did over the moment only what rest allows.
bool Sleep::rested(const Before& before, const Ball& ball, bool in_company) const {
    const double fall = length(gravity_) * moment_;
    if (fall == 0) return ball.velocity == Vec2{} && before.velocity == Vec2{} && ball.spin == 0;
    const double slowest = slow(in_company);
    const double steady = in_company ? company_gain * fall : 1e-3 * fall + 1e-2 * speed_;
    return length(ball.velocity) < slowest && length(before.velocity) < slowest &&
           std::abs(ball.spin) * ball.radius < slowest &&
           length(ball.position - before.position) < slowest * moment_ &&
           length(ball.velocity - before.velocity) <= std::min(steady, falling * fall);
}

}  // namespace flipside::custom

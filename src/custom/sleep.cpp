#include "custom/sleep.hpp"

#include <algorithm>

namespace flipside::custom {

namespace {

/// Balls that overlap anything by more than this, in radii, are on their way out of it.
constexpr double most_overlap = 0.005;

}  // namespace

void Sleep::watch(std::span<const Ball> balls) {
    before_.clear();
    for (const Ball& ball : balls)
        before_.push_back({ball.number, ball.position, ball.velocity, ball.radius, false});
}

void Sleep::squeeze(BallNumber number, double overlap) {
    const auto at = std::ranges::lower_bound(before_, number, {}, &Before::number);
    if (at != before_.end() && at->number == number && overlap > most_overlap * at->radius)
        at->squeezed = true;
}

void Sleep::settle(std::span<Ball> balls, std::span<const Contact> contacts, double dt) {
    for (const Contact& contact : contacts) {
        squeeze(contact.ball, -contact.separation);
        if (contact.other.is_ball) squeeze(contact.other.index, -contact.separation);
    }
    const double gain = 1e-3 * gravity_ * dt + 1e-2 * speed_;
    auto before = before_.begin();
    for (Ball& ball : balls) {
        while (before != before_.end() && before->number < ball.number) ++before;
        if (before == before_.end()) return;
        if (before->number != ball.number) continue;
        const bool slow = length(ball.velocity) < speed_ && length(before->velocity) < speed_ &&
                          std::abs(ball.spin) * ball.radius < speed_ &&
                          length(ball.position - before->position) < speed_ * dt;
        if (!slow || before->squeezed || length(ball.velocity - before->velocity) > gain) continue;
        ball.asleep = true;
        ball.velocity = {};
        ball.spin = 0;
    }
}

}  // namespace flipside::custom

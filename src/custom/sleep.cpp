#include "custom/sleep.hpp"

#include <algorithm>

namespace flipside::custom {

void Sleep::watch(std::span<const Ball> balls) {
    before_.clear();
    for (const Ball& ball : balls) before_.push_back({ball.number, ball.position, ball.velocity});
}

void Sleep::settle(std::span<Ball> balls, double dt) const {
    const double gain = 1e-3 * gravity_ * dt + 1e-2 * speed_;
    auto before = before_.begin();
    for (Ball& ball : balls) {
        while (before != before_.end() && before->number < ball.number) ++before;
        if (before == before_.end()) return;
        if (before->number != ball.number) continue;
        const bool slow = length(ball.velocity) < speed_ && length(before->velocity) < speed_ &&
                          std::abs(ball.spin) * ball.radius < speed_ &&
                          length(ball.position - before->position) < speed_ * dt;
        if (!slow || length(ball.velocity - before->velocity) > gain) continue;
        ball.asleep = true;
        ball.velocity = {};
        ball.spin = 0;
    }
}

}  // namespace flipside::custom

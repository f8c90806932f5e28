#include "lab/bot/still_watch.hpp"

#include <algorithm>

namespace flipside::lab::bot {

void StillWatch::look(double time, std::span<const Ball> balls) {
    std::erase_if(stays_, [&](const auto& entry) { return !find_ball(balls, entry.first); });
    for (const Ball& ball : balls) {
        const auto& launcher = scene_->launcher;
        if (launcher && length(ball.position - launcher->position) < region * ball.radius) {
            stays_.erase(ball.number);
            continue;
        }
        Stay& stay = stays_.try_emplace(ball.number, Stay{ball.position, time}).first->second;
        if (length(ball.position - stay.place) > region * ball.radius) stay = {ball.position, time};
        longest_ = std::max(longest_, time - stay.since);
        if (time - stay.since < stuck_after || stay.counted) continue;
        stay.counted = true;
        ++stuck_;
    }
}

}  // namespace flipside::lab::bot

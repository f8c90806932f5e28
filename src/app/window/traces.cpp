#include "app/window/traces.hpp"

#include <algorithm>

namespace flipside::app {

void Traces::observe(std::span<const Event> events, std::span<const Ball> balls, double time) {
    for (const Event& event : events) {
        if (event.kind != EventKind::impact && event.kind != EventKind::sensor_begin) continue;
        if (!event.other.is_ball) lit_[event.other.index] = time;
        if (event.kind != EventKind::impact) continue;
        hits_.push_back({time, event.point, event.speed, event.other.is_ball});
    }
    while (!hits_.empty() && (hits_.front().time < time - hit_seconds || hits_.size() > most_hits))
        hits_.pop_front();
    if (time >= followed_ + track_interval) follow(balls, time);
}

void Traces::follow(std::span<const Ball> balls, double time) {
    spacing_ = followed_ < 0 ? track_interval : time - followed_;
    const auto most = static_cast<std::size_t>(std::max(2.0, track_seconds / spacing_));
    followed_ = time;
    std::erase_if(tracks_, [&](const auto& entry) {
        return !std::ranges::binary_search(balls, entry.first, {}, &Ball::number);
    });
    for (const Ball& ball : balls) {
        std::deque<Vec2>& track = tracks_[ball.number];
        track.push_back(ball.position);
        while (track.size() > most) track.pop_front();
    }
}

double Traces::light(PartIndex part, double time) const {
    return std::clamp(1 - (time - lit_[part]) / light_seconds, 0.0, 1.0);
}

}  // namespace flipside::app

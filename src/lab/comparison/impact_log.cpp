#include "lab/comparison/impact_log.hpp"

#include <algorithm>
#include <cmath>

namespace flipside::lab {

namespace {

constexpr double same_time = 1e-9;  ///< s

/// An impulse J changes the normal speed by J over the reduced mass; parts are too heavy to yield.
std::optional<double> leaving_speed(const Event& event, std::span<const Ball> balls) {
    const Ball* ball = find_ball(balls, event.ball);
    const Ball* other = event.other.is_ball ? find_ball(balls, event.other.index) : nullptr;
    if (!ball || (event.other.is_ball && !other)) return std::nullopt;
    const double yield = 1 / ball->mass + (other ? 1 / other->mass : 0);
    return event.impulse * yield - event.speed;
}

std::optional<Impact> last_that(const std::deque<Impact>& impacts, auto&& holds) {
    const auto at = std::find_if(impacts.rbegin(), impacts.rend(), holds);
    return at == impacts.rend() ? std::nullopt : std::optional(*at);
}

}  // namespace

void ImpactLog::observe(std::span<const Event> events, std::span<const Ball> balls) {
    for (const Event& event : events)
        if (event.kind == EventKind::impact) impacts_.push_back({event, leaving_speed(event, balls)});
    while (impacts_.size() > most ||
           (!impacts_.empty() && impacts_.front().event.time < impacts_.back().event.time - longest))
        impacts_.pop_front();
}

void ImpactLog::forget_after(double time) {
    while (!impacts_.empty() && impacts_.back().event.time > time + same_time) impacts_.pop_back();
}

std::optional<Impact> ImpactLog::last(double until) const {
    return last_that(impacts_, [&](const Impact& impact) { return impact.event.time <= until + same_time; });
}

std::optional<Impact> ImpactLog::last(Other subject, double until) const {
    return last_that(impacts_, [&](const Impact& impact) {
        return impact.event.time <= until + same_time && concerns(impact.event, subject);
    });
}

std::optional<Impact> ImpactLog::nearest(const Event& like, double tolerance, double until) const {
    const Impact* found = nullptr;
    double least = tolerance;
    for (auto at = impacts_.rbegin(); at != impacts_.rend() && at->event.time >= like.time - least; ++at) {
        const double apart = std::abs(at->event.time - like.time);
        if (at->event.time > until + same_time || apart > least) continue;
        if (at->event.ball == like.ball && at->event.other == like.other) least = apart, found = &*at;
    }
    return found ? std::optional(*found) : std::nullopt;
}

}  // namespace flipside::lab

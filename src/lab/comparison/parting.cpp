#include "lab/comparison/parting.hpp"

#include <algorithm>
#include <cmath>

namespace flipside::lab {

namespace {

using Impacts = std::map<BallNumber, std::vector<const Event*>>;

/// Puts every impact of one run to its ball; balls without any are there if `balls` has them.
Impacts by_ball(std::span<const Event> events) {
    Impacts impacts;
    for (const Event& event : events)
        if (event.kind == EventKind::impact) impacts[event.ball].push_back(&event);
    return impacts;
}

/// The first index at which the impacts of one ball differ, or nothing.
std::optional<Parting> parting_of(BallNumber ball, const std::vector<const Event*>& first,
                                  const std::vector<const Event*>& second, double tolerance, double end) {
    for (std::size_t i = 0; i < std::max(first.size(), second.size()); ++i) {
        Parting parting{end, ball, i, {}, {}};
        if (i < first.size()) parting.first = *first[i];
        if (i < second.size()) parting.second = *second[i];
        if (parting.first && parting.second && same_impact(*parting.first, *parting.second, tolerance))
            continue;
        if (parting.first) parting.time = std::min(parting.time, parting.first->time);
        if (parting.second) parting.time = std::min(parting.time, parting.second->time);
        // The other run may have had it right after the end.
        if (!(parting.first && parting.second) && parting.time >= end - tolerance) return std::nullopt;
        return parting;
    }
    return std::nullopt;
}

/// How many impacts have the same other, in order.
std::size_t same_others(const std::vector<const Event*>& first, const std::vector<const Event*>& second) {
    const auto [end, _] = std::ranges::mismatch(first, second, {}, &Event::other, &Event::other);
    return static_cast<std::size_t>(end - first.begin());
}

}  // namespace

bool same_impact(const Event& first, const Event& second, double tolerance) {
    return first.other == second.other && std::abs(first.time - second.time) <= tolerance;
}

ImpactMatch match_impacts(std::span<const Event> first, std::span<const Event> second, double tolerance,
                          double end) {
    Impacts firsts = by_ball(first), seconds = by_ball(second);
    for (const auto& entry : seconds) firsts[entry.first];
    ImpactMatch match;
    for (const auto& [ball, impacts] : firsts) {
        const auto& others = seconds[ball];
        const auto parting = parting_of(ball, impacts, others, tolerance, end);
        match.matched[ball] = parting ? parting->index : std::min(impacts.size(), others.size());
        match.total += match.matched[ball];
        match.in_order += same_others(impacts, others);
        if (parting && (!match.parting || parting->time < match.parting->time)) match.parting = parting;
    }
    for (const auto& [ball, count] : match.matched) {
        const auto& impacts = firsts[ball];
        const double until = match.parting ? match.parting->time : end;
        match.before_parting += static_cast<std::size_t>(
            std::count_if(impacts.begin(), impacts.begin() + static_cast<std::ptrdiff_t>(count),
                          [&](const Event* impact) { return impact->time <= until; }));
    }
    return match;
}

Spread spread(std::span<const Ball> first, std::span<const Ball> second) {
    Spread spread;
    auto b = second.begin();
    for (const Ball& ball : first) {
        while (b != second.end() && b->number < ball.number) ++b;
        if (b == second.end() || b->number != ball.number) continue;
        ++spread.common;
        const double radii = length(ball.position - b->position) / ball.radius;
        if (radii > spread.radii) {
            spread.radii = radii;
            spread.ball = ball.number;
        }
    }
    spread.same_balls = spread.common == first.size() && spread.common == second.size();
    return spread;
}

}  // namespace flipside::lab

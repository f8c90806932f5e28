#pragma once
/// Where two runs of one scene diverge: in the sequence of impacts, and in the positions of the balls.

#include <map>
#include <optional>
#include <span>
#include <vector>

#include "world/events.hpp"

namespace flipside::lab {

/// The first impact of a ball that is not the same in both runs.
struct Parting {
    double time = 0;  ///< s, of the earlier of the two
    BallNumber ball = 0;
    std::size_t index = 0;               ///< of the impact among this ball's, from 0
    std::optional<Event> first, second;  ///< nothing where that run has no further impact of this ball
};

struct ImpactMatch {
    std::map<BallNumber, std::size_t>
        matched;                     ///< per ball: impacts that agree before its first that does not
    std::size_t total = 0;           ///< the sum of those
    std::size_t in_order = 0;        ///< the same count where only the others must agree, whatever the times
    std::size_t before_parting = 0;  ///< those at or before the time of the first parting
    std::optional<Parting> parting;  ///< the earliest over all balls
};

/// The same other, and at most `tolerance` s between their times.
[[nodiscard]] bool same_impact(const Event& first, const Event& second, double tolerance);

/// Compares the impacts ball by ball in their order, by same_impact. An impact that one run lacks counts only
/// if it happened more than `tolerance` before `end`. Impacts between balls belong to the lower number.
/// Events of other kinds are passed over.
[[nodiscard]] ImpactMatch match_impacts(std::span<const Event> first, std::span<const Event> second,
                                        double tolerance, double end);

/// The greatest distance between the same balls of two runs.
struct Spread {
    double radii = 0;  ///< in radii of that ball
    BallNumber ball = 0;
    std::size_t common = 0;  ///< balls that both have
    bool same_balls = true;  ///< false when one run has a ball that the other has not
};
/// Both by rising number.
[[nodiscard]] Spread spread(std::span<const Ball> first, std::span<const Ball> second);

}  // namespace flipside::lab

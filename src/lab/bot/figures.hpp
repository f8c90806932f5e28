#pragma once
/// What many games come to.

#include <map>
#include <span>
#include <string>

#include "lab/bot/play.hpp"

namespace flipside::lab::bot {

/// The values that a quarter, a half and three quarters of all do not exceed, and the greatest.
struct Spread {
    double quarter = 0, median = 0, three_quarters = 0, greatest = 0;
};
/// Needs at least one value. Between two values in order the straight line counts.
[[nodiscard]] Spread spread_of(std::vector<double> values);

struct Figures {
    Spread seconds, score;
    std::size_t unfinished = 0;
    long lost = 0;  ///< balls drained
    std::uint64_t strays = 0;
    int stuck = 0;
    int searches = 0;
    double longest_still = 0;
    std::map<std::string, int> drained_after;
};
/// Needs at least one game.
[[nodiscard]] Figures figures_of(std::span<const Played> games);

/// A row per game; the columns are those of `games_header`.
inline constexpr std::string_view games_header =
    "game,seed,score,seconds,finished,launched,drained,strays,stuck,longest_still,searches,nudges\n";
void write_games(std::ostream& out, std::span<const Played> games);

}  // namespace flipside::lab::bot

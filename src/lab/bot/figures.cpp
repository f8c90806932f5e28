#include "lab/bot/figures.hpp"

#include <algorithm>

#include "lab/files/csv.hpp"

namespace flipside::lab::bot {

namespace {

double at_share(std::span<const double> sorted, double share) {
    const double place = share * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    return sorted[below] + (place - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

}  // namespace

Spread spread_of(std::vector<double> values) {
    std::ranges::sort(values);
    return {at_share(values, 0.25), at_share(values, 0.5), at_share(values, 0.75), values.back()};
}

Figures figures_of(std::span<const Played> games) {
    Figures figures;
    std::vector<double> seconds, scores;
    for (const Played& game : games) {
        seconds.push_back(game.seconds);
        scores.push_back(static_cast<double>(game.score));
        if (!game.finished) ++figures.unfinished;
        figures.lost += game.lost;
        figures.strays += game.strays;
        figures.stuck += game.stuck;
        figures.searches += game.searches;
        figures.longest_still = std::max(figures.longest_still, game.longest_still);
        for (const auto& [name, count] : game.drained_after) figures.drained_after[name] += count;
    }
    figures.seconds = spread_of(std::move(seconds));
    figures.score = spread_of(std::move(scores));
    return figures;
}

void write_games(std::ostream& out, std::span<const Played> games) {
    CsvRow row;
    for (std::size_t i = 0; i < games.size(); ++i) {
        const Played& game = games[i];
        row.add(static_cast<std::uint64_t>(i)).add(game.seed).add(static_cast<double>(game.score));
        row.add(game.seconds).add(std::string_view(game.finished ? "yes" : "no"));
        row.add(static_cast<std::uint64_t>(game.launched)).add(static_cast<std::uint64_t>(game.lost));
        row.add(game.strays).add(static_cast<std::uint64_t>(game.stuck)).add(game.longest_still);
        row.add(static_cast<std::uint64_t>(game.searches));
        row.add(static_cast<std::uint64_t>(game.nudges)).write(out);
    }
}

}  // namespace flipside::lab::bot

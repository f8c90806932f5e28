#include "lab/compare.hpp"

#include <algorithm>

namespace flipside::lab {

namespace {

/// The last impact that `ball` took part in.
std::optional<Event> last_impact(const std::vector<Event>& impacts, BallNumber ball) {
    const auto at = std::find_if(impacts.rbegin(), impacts.rend(), [&](const Event& impact) {
        return impact.ball == ball || impact.other == Other::ball(ball);
    });
    return at == impacts.rend() ? std::nullopt : std::optional(*at);
}

void watch_pair(Pair& pair, std::span<const Session> sessions, const std::vector<EngineRun>& runs,
                double time) {
    pair.at_end = spread(sessions.front().world().balls(), sessions[pair.second].world().balls());
    pair.radii.push_back(pair.at_end.radii);
    if (pair.parted || (pair.at_end.radii <= 1 && pair.at_end.same_balls)) return;
    pair.parted = {time, pair.at_end, last_impact(runs.front().impacts, pair.at_end.ball)};
}

}  // namespace

Comparison compare(CompareInput input, const std::function<void(double)>& watch) {
    Comparison result{std::move(input), {}, {}, {}};
    std::vector<Session> sessions;
    std::vector<double> energy_first;
    for (const Contender& contender : result.input.contenders) {
        sessions.emplace_back(result.input.scene, *contender.engine, contender.settings);
        energy_first.push_back(energy(sessions.back().world(), *result.input.scene));
        result.runs.push_back({contender, {}, {}});
    }
    for (std::size_t i = 1; i < sessions.size(); ++i) {
        result.pairs.emplace_back();
        result.pairs.back().second = i;
    }

    const Timeline timeline(0, result.input.seconds, result.input.dt);
    const auto after = [&](const Session& session, std::uint64_t, double time) {
        const auto index = static_cast<std::size_t>(&session - sessions.data());
        std::ranges::copy_if(session.events(), std::back_inserter(result.runs[index].impacts),
                             [](const Event& event) { return event.kind == EventKind::impact; });
        if (index + 1 < sessions.size()) return;
        result.times.push_back(time);
        for (Pair& pair : result.pairs) watch_pair(pair, sessions, result.runs, time);
        if (watch) watch(time);
    };
    run(sessions, timeline, result.input.script, after);

    for (std::size_t i = 0; i < sessions.size(); ++i)
        result.runs[i].figures = figures_of(sessions[i], result.input.seconds, energy_first[i]);
    // Engines that only know contacts per step give the step's end: one step is what they may differ by.
    const double tolerance = result.input.dt * (1 + 1e-9);
    for (Pair& pair : result.pairs)
        pair.match = match_impacts(result.runs.front().impacts, result.runs[pair.second].impacts, tolerance,
                                   timeline.end());
    return result;
}

}  // namespace flipside::lab

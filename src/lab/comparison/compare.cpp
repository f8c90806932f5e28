#include "lab/comparison/compare.hpp"

#include <algorithm>

#include "world/clock.hpp"
#include "world/refusal.hpp"

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

/// Runs a part of a session. What ends it is told.
std::optional<EngineRun::Ended> end_of(const Session& session, const std::function<void()>& part) {
    try {
        part();
        return std::nullopt;
    } catch (const Refusal& refusal) {
        return EngineRun::Ended{session.world().time(), refusal.what()};
    } catch (const NotANumber& failure) {
        return EngineRun::Ended{session.world().time(), failure.what()};
    }
}

}  // namespace

Comparison compare(CompareInput input, const std::function<void(double)>& watch) {
    Comparison result{std::move(input), {}, {}, 0, {}};
    result.dt = common_step(result.input.contenders);
    std::vector<Session> sessions;
    std::vector<double> energy_first;
    for (const Contender& contender : result.input.contenders) {
        sessions.emplace_back(result.input.scene, *contender.engine, contender.settings,
                              WithoutWorld::refuse_steps);
        energy_first.push_back(energy(sessions.back().world(), *result.input.scene));
        result.runs.push_back({contender, {}, {}});
    }
    for (std::size_t i = 1; i < sessions.size(); ++i) {
        result.pairs.emplace_back();
        result.pairs.back().second = i;
    }

    const Timeline timeline(0, result.input.seconds, result.dt);
    // The run of all, and one more for each of them: about as long.
    const double share = 1 / (1 + static_cast<double>(sessions.size()));
    double done = 0;
    const auto watch_part = [&](double time) {
        if (watch) watch(done + share * std::min(1.0, time / result.input.seconds));
    };
    std::vector<std::size_t> next(sessions.size(), next_control(result.input.script, timeline.start()));
    Clock clock;
    for (std::uint64_t k = 0; k < timeline.steps(); ++k) {
        for (std::size_t i = 0; i < sessions.size(); ++i) {
            const Timeline own(0, timeline.length(k), result.runs[i].contender.dt);
            const auto collect = [&](const Session& session, std::uint64_t, double) {
                std::ranges::copy_if(session.events(), std::back_inserter(result.runs[i].impacts),
                                     [](const Event& event) { return event.kind == EventKind::impact; });
            };
            if (!result.runs[i].ended)
                result.runs[i].ended = end_of(
                    sessions[i], [&] { run_on(sessions[i], own, result.input.script, next[i], collect); });
        }
        clock.advance(timeline.length(k));
        result.times.push_back(k + 1 == timeline.steps() ? timeline.end() : clock.time);
        for (Pair& pair : result.pairs)
            if (!result.runs.front().ended && !result.runs[pair.second].ended)
                watch_pair(pair, sessions, result.runs, result.times.back());
        watch_part(result.times.back());
    }

    const auto last_time = [&](const EngineRun& one) { return one.ended ? one.ended->time : timeline.end(); };
    for (std::size_t i = 0; i < sessions.size(); ++i)
        result.runs[i].figures = figures_of(sessions[i], last_time(result.runs[i]), energy_first[i]);
    // Engines that only know contacts per step give the step's end: one step is what they may differ by.
    for (Pair& pair : result.pairs) {
        const double step = std::max(result.runs.front().contender.dt, result.runs[pair.second].contender.dt);
        pair.match =
            match_impacts(result.runs.front().impacts, result.runs[pair.second].impacts, step * (1 + 1e-9),
                          std::min(last_time(result.runs.front()), last_time(result.runs[pair.second])));
    }
    for (EngineRun& run : result.runs) {
        done += share;
        if (run.contender.engine->name != "reference")
            run.blame = blame_run(result.input.scene, run.contender,
                                  run.ended ? run.ended->time : result.input.seconds, result.input.script,
                                  watch_part);
    }
    return result;
}

}  // namespace flipside::lab

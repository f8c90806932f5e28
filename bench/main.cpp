// Speed by regime: CPU time per ball and step of the bespoke engine, of Box2D and of a bare loop, in one
// process and a quarter of a simulated second in turn, so that what else the machine does meets all alike.
// Prints a Markdown table: the least of the repeats, which are as many for all, the ratio to the bare loop,
// and what the speed was bought with.
//
//   flipside_bench [--only TEXT] [--repeats N] [--growth]

#include <cmath>
#include <cstdio>
#include <iostream>
#include <numeric>

#include <CLI/CLI.hpp>

#include "contender.hpp"
#include "lab/contenders/engines.hpp"
#include "lab/report/facts.hpp"
#include "lab/session/session.hpp"
#include "regimes.hpp"
#include "world/refusal.hpp"

namespace {

using namespace flipside;
using namespace flipside::bench;

const std::vector<Contender::Kind> kinds{
    {"bare loop", "", {}, false},
    {"custom", "custom", {"solver=continuous"}, false},
    {"custom, read each step", "custom", {"solver=continuous"}},
    {"custom, simple", "custom", {"solver=simple"}},
    {"Box2D", "box2d", {}},
    {"Box2D, no bullets", "box2d", {"bullets=off"}},
    {"Box2D, nothing continuous", "box2d", {"bullets=off", "continuous=off"}},
};

/// What a row says of one contender.
struct Result {
    double nanoseconds = INFINITY, own = INFINITY, deepest = 0, drift = 0;
    std::size_t lost = 0, asleep = 0;
};

int steps_in(double seconds) {
    return static_cast<int>(std::lround(seconds / dt));
}

/// Every contender on the scenes of a regime, in turn; sums over the scenes.
std::vector<Result> run_once(const Regime& regime, std::span<const Contender::Kind> taking_part) {
    constexpr int slice = 15;  // steps
    std::vector<Result> sums(taking_part.size(), {0, 0, 0, 0, 0, 0});
    const auto scenes = regime.scenes();
    for (const auto& scene : scenes) {
        std::vector<Contender> contenders;
        for (const Contender::Kind& kind : taking_part) contenders.emplace_back(kind, scene);
        for (Contender& contender : contenders) contender.run(steps_in(regime.from), false);
        const int steps = steps_in(regime.seconds);
        for (int done = 0; done < steps; done += slice)
            for (Contender& contender : contenders) contender.run(std::min(slice, steps - done), true);
        for (std::size_t i = 0; i < sums.size(); ++i) {
            const Contender& from = contenders[i];
            sums[i].nanoseconds += from.nanoseconds() / static_cast<double>(scenes.size());
            sums[i].own += from.own_nanoseconds() / static_cast<double>(scenes.size());
            sums[i].deepest = std::max(sums[i].deepest, from.deepest());
            sums[i].drift += from.drift();
            sums[i].lost += from.lost();
            sums[i].asleep += from.asleep();
        }
    }
    return sums;
}

/// How far the worst ball is from where the reference has it, a tenth of a second after the state at the
/// regime's beginning, radii; none where the reference refuses.
std::optional<double> error_of(const Regime& regime, const Contender::Kind& kind) {
    constexpr int window = 6;  // steps
    const auto scene = regime.scenes().front();
    Contender leader({"", "custom", {"solver=continuous"}, false}, scene);
    leader.run(steps_in(regime.from), false);
    State state = leader.world()->save();
    state.origin.reset();
    Contender truth({"", "reference", {}, false}, scene), contender(kind, scene);
    try {
        for (Contender* one : {&truth, &contender}) {
            one->world()->restore(state);
            one->run(window, false);
        }
    } catch (const Refusal&) {
        return {};
    }
    const auto a = truth.world()->balls(), b = contender.world()->balls();
    if (a.size() != b.size() || a.empty()) return INFINITY;
    double worst = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        worst = std::max(worst, length(a[i].position - b[i].position) / a[i].radius);
    return worst;
}

void show(const Regime& regime, int repeats, std::span<const Contender::Kind> taking_part, bool with_errors) {
    std::vector<Result> least(taking_part.size());
    for (int repeat = 0; repeat < repeats; ++repeat) {
        const auto results = run_once(regime, taking_part);
        for (std::size_t i = 0; i < least.size(); ++i) {
            const double fastest = std::min(least[i].nanoseconds, results[i].nanoseconds);
            const double own = std::min(least[i].own, results[i].own);
            least[i] = results[i];
            least[i].nanoseconds = fastest, least[i].own = own;
        }
    }
    const bool bare = taking_part.front().engine.empty();
    for (std::size_t i = 0; i < least.size(); ++i) {
        const Contender::Kind& kind = taking_part[i];
        const Result& result = least[i];
        std::printf("| %s | %d | %s | %.3g ns |", regime.name.c_str(), regime.balls, kind.name.c_str(),
                    result.nanoseconds);
        std::printf(kind.engine == "box2d" ? " %.3g ns |" : " |", result.own);
        if (bare)
            std::printf(" %.2g |", result.nanoseconds / least.front().nanoseconds);
        else
            std::printf(" |");
        if (kind.engine.empty()) {
            std::printf(" | | | %zu |\n", result.lost);
            continue;
        }
        const auto error = with_errors ? error_of(regime, kind) : std::nullopt;
        error ? std::printf(" %.2g |", *error) : std::printf(" |");
        std::printf(" %.2g |", result.deepest);
        regime.keeps_energy ? std::printf(" %.1e |", result.drift) : std::printf(" |");
        std::printf(" %zu |\n", result.lost);
    }
    std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) try {
    CLI::App app("Speed by regime, as a Markdown table");
    std::string only;
    int repeats = 3;
    bool grows = false;
    app.add_option("--only", only, "regimes whose name contains this");
    app.add_option("--repeats", repeats, "of each row, for every contender alike")
        ->check(CLI::Range(1, 1000));
    app.add_flag("--growth", grows, "the bespoke engine alone with up to 100,000 balls");
    CLI11_PARSE(app, argc, argv);

    for (const auto& [name, value] : lab::report::build_facts())
        std::printf("%s: %s\n", name.c_str(), value.c_str());
    std::printf("least of %d runs; steps of 1/60 s\n\n", repeats);
    std::printf(
        "| regime | balls | contender | per ball and step | its own step | / bare loop | error, r |"
        " deepest overlap, r | energy | lost |\n|---|---|---|---|---|---|---|---|---|---|\n");
    for (const Regime& regime : grows ? growth() : regimes()) {
        if (regime.name.find(only) == std::string::npos) continue;
        const auto all = std::span(kinds);
        const auto taking_part = grows ? all.subspan(0, 2) : regime.bare ? all : all.subspan(1);
        show(regime, repeats, taking_part, !grows);
    }
    return 0;
} catch (const std::exception& error) {
    std::cerr << "flipside_bench: " << error.what() << '\n';
    return 1;
}

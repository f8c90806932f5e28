// Speed by regime (lab/regimes): CPU time per ball and step of all engines and of a bare loop, as a Markdown
// table: the median of the repeats with its 95 % confidence interval (fewer than six: the range), the ratio
// to the bare loop, and what the speed was bought with.
//
//   flipside_bench [--only TEXT] [--repeats N] [--growth | --heaps] [--engine LIBRARY]

#include <cstdio>
#include <iostream>

#include <CLI/CLI.hpp>

#include "lab/contenders/engines.hpp"
#include "lab/regimes/measure.hpp"
#include "lab/report/facts.hpp"
#include "lab/statistics/median.hpp"
#include "plugin/worker.hpp"

namespace {

using namespace flipside::lab;

void show(const regimes::Result& result, std::optional<double> bare) {
    const std::string& name = result.kind.name;
    std::printf("| %s | %d | %s |", result.regime.c_str(), result.balls, name.c_str());
    if (!result.failure.empty()) {
        std::printf(" %s | | | | | | |\n", result.failure.c_str());
        return;
    }
    const Median cost = median_of(result.nanoseconds);
    std::printf(" %.3g ns (%.3g to %.3g) |", cost.value, cost.low, cost.high);
    result.own > 0 ? std::printf(" %.3g ns |", result.own) : std::printf(" |");
    bare ? std::printf(" %.2g |", cost.value / *bare) : std::printf(" |");
    result.error ? std::printf(" %.2g |", *result.error) : std::printf(" |");
    result.kind.engine.empty() ? std::printf(" |") : std::printf(" %.2g |", result.deepest);
    result.drift ? std::printf(" %.1e |", *result.drift) : std::printf(" |");
    std::printf(" %zu |\n", result.lost);
}

void show(const regimes::Course& course, const std::string& only, std::span<const regimes::Kind> kinds,
          const regimes::Measuring& how) {
    const auto is_wanted = [&](const auto& regime) { return regime.find(only) != std::string::npos; };
    if (std::ranges::none_of(course.regimes, is_wanted, &regimes::Regime::name)) return;
    std::optional<double> bare;
    for (const regimes::Result& result : measure(course, kinds, how)) {
        if (result.kind.engine.empty() && result.failure.empty()) bare = median_of(result.nanoseconds).value;
        if (is_wanted(result.regime)) show(result, course.bare ? bare : std::nullopt);
    }
    std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) try {
    if (flipside::plugin::is_engine_process(argc, argv)) flipside::plugin::run_engine_process(argv[2]);
    CLI::App app("Speed by regime, as a Markdown table");
    std::string only;
    std::vector<std::string> libraries;
    regimes::Measuring how;
    bool grows = false, heaps = false;
    app.add_option("--only", only, "regimes whose name contains this");
    app.add_option("--repeats", how.repeats, "of each course, for every contender alike")
        ->check(CLI::Range(1, 1000));
    app.add_option("--engine", libraries, "libraries of engines that take part too");
    CLI::Option* growth = app.add_flag("--growth", grows,
                                       "the bare loop and the bespoke engine alone with up to 100,000 balls");
    app.add_flag("--heaps", heaps, "rain of 3,200 balls that settle and lie in heaps, alone")
        ->excludes(growth);
    CLI11_PARSE(app, argc, argv);

    for (const std::string& library : libraries) static_cast<void>(engine_named(library));
    for (const auto& [name, value] : report::build_facts())
        std::printf("%s: %s\n", name.c_str(), value.c_str());
    std::printf("%d runs of each; steps of 1/60 s\n\n", how.repeats);
    std::printf(
        "| regime | balls | contender | per ball and step | its own step | / bare loop | error, r |"
        " deepest overlap, r | energy | lost |\n|---|---|---|---|---|---|---|---|---|---|\n");
    const std::vector<regimes::Kind> kinds = regimes::kinds();
    how.with_errors = !grows;
    const auto courses = grows ? regimes::growth() : heaps ? regimes::heaps() : regimes::courses();
    for (const regimes::Course& course : courses) {
        const auto all = std::span(kinds);
        show(course, only, grows ? all.first(2) : course.bare ? all : all.subspan(1), how);
    }
    return 0;
} catch (const std::exception& error) {
    std::cerr << "flipside_bench: " << error.what() << '\n';
    return 1;
}

#include "lab/comparison/compare.hpp"

#include <algorithm>

#include "app/cli/commands.hpp"
#include "app/cli/output.hpp"
#include "app/cli/output_file.hpp"
#include "app/cli/progress.hpp"
#include "app/cli/run_options.hpp"
#include "lab/contenders/engines.hpp"
#include "lab/files/csv.hpp"
#include "world/input_error.hpp"
#include "world/printable.hpp"

namespace flipside::app {

namespace {

struct CompareOptions : RunOptions {
    std::vector<std::string> engines{"custom", "box2d"};
    std::vector<std::string> contenders;  ///< as on the command line; none: the engines as they are
    std::string json;                     ///< file; "" where not asked for
};

std::string name_of(const lab::EngineRun& run) {
    return printable(run.contender.name);
}

/// Of the first column, so that every name fits.
int name_width(const lab::Comparison& comparison) {
    std::size_t widest = 10;
    for (const lab::EngineRun& run : comparison.runs) widest = std::max(widest, name_of(run).size());
    return static_cast<int>(widest);
}

void print_run(const lab::EngineRun& run, int width) {
    const lab::RunFigures& f = run.figures;
    const lab::Totals& t = f.totals;
    const double per_step = t.steps > 0 ? 1e6 * t.step_seconds / static_cast<double>(t.steps) : 0;
    const double per_second = f.sim_seconds > 0 ? 1e3 * t.step_seconds / f.sim_seconds : 0;
    print("%-*s %9.6g %7llu %9.2f %9.3f %11.4g %11.4g %11.3g %8llu %9llu %6llu %8.3g\n", width,
          name_of(run).c_str(), 1e3 * run.contender.dt, static_cast<unsigned long long>(t.steps), per_step,
          per_second, f.energy_first, f.energy_last, f.energy_last - f.energy_first,
          static_cast<unsigned long long>(t.impacts), static_cast<unsigned long long>(t.launched),
          static_cast<unsigned long long>(t.lost), 1e3 * t.max_penetration);
}

void print_impact(const std::string& engine, const std::optional<Event>& impact, const Scene& scene) {
    if (!impact) {
        print("  %-10s no further impact of this ball\n", engine.c_str());
        return;
    }
    print("  %-10s ball %u on %s at %.6f s, point (%.5f, %.5f) m, %.4g m/s\n", engine.c_str(), impact->ball,
          printable(lab::name_of_other(*impact, scene)).c_str(), impact->time, impact->point.x,
          impact->point.y, impact->speed);
}

void print_pair(const lab::Pair& pair, const lab::Comparison& comparison) {
    const Scene& scene = *comparison.input.scene;
    const std::string first = name_of(comparison.runs.front());
    const std::string second = name_of(comparison.runs[pair.second]);
    const lab::ImpactMatch& match = pair.match;
    print("\n%s and %s: %zu contacts with the same parts in the same order, %zu of them within a step",
          first.c_str(), second.c_str(), match.in_order, match.total);
    if (const auto& parting = match.parting) {
        print(", %zu before they part\n", match.before_parting);
        print("First impact where they part: number %zu of ball %u, at %.4f s\n", parting->index + 1,
              parting->ball, parting->time);
        print_impact(first, parting->first, scene);
        print_impact(second, parting->second, scene);
    } else {
        print("; no impact where they part\n");
    }
    if (const auto& parted = pair.parted) {
        const std::string on = parted->after
                                   ? ", after ball " + std::to_string(parted->spread.ball) + " met " +
                                         printable(lab::name_of_other(*parted->after, scene))
                                   : "";
        const char* how = parted->spread.same_balls ? "a ball is more than its radius apart"
                                                    : "one has a ball that the other has not";
        print("Positions: at %.4f s %s%s; %.3g radii apart at the end\n", parted->time, how, on.c_str(),
              pair.at_end.radii);
    } else {
        print("Positions: never a radius apart; %.3g radii at the end\n", pair.at_end.radii);
    }
    if (match.matched.size() < 2) return;
    print("Contacts matched by ball:");
    constexpr std::size_t enough = 12;
    std::size_t shown = 0;
    for (const auto& [ball, count] : match.matched)
        if (shown++ < enough) print(" %u:%zu", ball, count);
    print(shown > enough ? " ...\n" : "\n");
}

/// Of each contender, the first wrong decision, by the reference's account.
void print_blame(const lab::Comparison& comparison) {
    print("\nBlame: the first wrong decision of each, by the reference's account\n");
    for (const lab::EngineRun& run : comparison.runs) {
        if (!run.blame) continue;
        const lab::RunBlame& found = *run.blame;
        if (found.blame)
            print("  %-10s %s; ball %u is %.3g radii off at %.4f s\n", name_of(run).c_str(),
                  lab::in_words(*found.blame, *comparison.input.scene).c_str(), found.ball, found.radii,
                  found.until);
        else
            print("  %-10s none until %.4f s%s%s\n", name_of(run).c_str(), found.until,
                  found.why.empty() ? "" : ": ", printable(found.why).c_str());
    }
}

void print_comparison(const lab::Comparison& comparison) {
    const lab::CompareInput& input = comparison.input;
    const int width = name_width(comparison);
    print("%s: %g s, compared every %.6g s\n\n", printable(input.scene->name).c_str(), input.seconds,
          comparison.dt);
    print("%-*s %9s %7s %9s %9s %11s %11s %11s %8s %9s %6s %8s\n", width, "engine", "step", "steps",
          "CPU/step", "CPU/sim.s", "energy", "energy", "energy", "impacts", "launched", "lost", "deepest");
    print("%-*s %9s %7s %9s %9s %11s %11s %11s %8s %9s %6s %8s\n", width, "", "ms", "", "us", "ms",
          "first, J", "last, J", "drift, J", "", "", "", "mm");
    for (const lab::EngineRun& run : comparison.runs) print_run(run, width);
    print("(%s)\n", lab::libraries().c_str());
    for (const lab::EngineRun& run : comparison.runs)
        if (run.ended)
            print("%s ended at %.6g s: %s\n", name_of(run).c_str(), run.ended->time,
                  printable(run.ended->why).c_str());
    for (const lab::Pair& pair : comparison.pairs) print_pair(pair, comparison);
    print_blame(comparison);
}

std::vector<const Engine*> chosen_engines(const std::vector<std::string>& names) {
    std::vector<const Engine*> engines;
    for (const std::string& name : names) {
        const Engine* engine = &lab::engine_named(name);
        if (std::ranges::find(engines, engine) != engines.end())
            throw InputError("engine '" + name + "' is there twice; compare takes different ones");
        engines.push_back(engine);
    }
    return engines;
}

/// The engines as they are, where no contenders are named.
std::vector<lab::ContenderRequest> requests_of(const CompareOptions& options) {
    if (!options.contenders.empty()) return lab::parse_contenders(options.contenders);
    std::vector<lab::ContenderRequest> requests;
    for (const Engine* engine : chosen_engines(options.engines))
        requests.push_back(lab::plain_contender(*engine));
    return requests;
}

int compare(const CompareOptions& options) {
    const std::vector<lab::ContenderRequest> requests = requests_of(options);
    std::vector<const Engine*> engines;
    for (const lab::ContenderRequest& request : requests)
        if (std::ranges::find(engines, request.engine) == engines.end()) engines.push_back(request.engine);
    const auto changes = lab::parse_changes(options.settings, engines);
    require_distinct({options.inputs(), {{"--json", options.json}}, true});
    lab::CompareInput input;
    input.scene = options.load();
    for (const lab::ContenderRequest& request : requests)
        input.contenders.push_back(
            lab::contender_for(request, *input.scene, options.step(*input.scene), changes));
    note_idle(requests, *input.scene, changes);
    input.seconds = options.seconds;
    input.script = options.load_script(*input.scene);

    OutputFile json(options.json);
    const lab::Comparison comparison = [&] {
        Progress progress(1);
        return lab::compare(std::move(input), [&](double share) { progress.at(share); });
    }();
    if (auto* out = json.out()) *out << to_json(comparison);
    json.finish();
    print_comparison(comparison);
    const auto ended = [](const lab::EngineRun& run) { return run.ended.has_value(); };
    return std::ranges::any_of(comparison.runs, ended) ? 1 : 0;
}

}  // namespace

void add_compare(CLI::App& program, Action& chosen) {
    auto options = std::make_shared<CompareOptions>();
    CLI::App& command =
        *program.add_subcommand("compare",
                                "Run a scene on several engines side by side: cost, energy, where they part, "
                                "and the first wrong decision of each (exit 1 where "
                                "one could not go on)");
    options->add_to(command, "E.K=V");
    options->add_seconds(command);
    CLI::Option* engines =
        command
            .add_option("--engines", options->engines, "The engines; the others are held against the first")
            ->delimiter(',')
            ->allow_extra_args(false)
            ->type_name("E,E,...");
    add_contenders(command, options->contenders)->excludes(engines);
    command.add_option("--json", options->json, "Everything found, as JSON")->type_name("FILE");
    command.callback([options, &chosen] { chosen = [options] { return compare(*options); }; });
}

}  // namespace flipside::app

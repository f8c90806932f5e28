#include "lab/sweep/sweep.hpp"

#include <algorithm>

#include "app/cli/commands.hpp"
#include "app/cli/output.hpp"
#include "app/cli/progress.hpp"
#include "app/cli/run_options.hpp"
#include "app/cli/shard.hpp"
#include "app/cli/tuning.hpp"
#include "lab/contenders/engines.hpp"
#include "lab/files/assets.hpp"
#include "lab/sweep/blame_counts.hpp"
#include "world/input_error.hpp"
#include "world/json_file.hpp"
#include "world/printable.hpp"

namespace flipside::app {

namespace {

namespace sweep = lab::sweep;

struct SweepOptions {
    std::vector<std::string> scenes;
    int balls = 0;
    std::vector<std::string> contenders, engines;
    std::vector<std::string> defined;  ///< contenders, as texts
    int finest = sweep::finest_steps;
    bool quick = false, every_window = false;
    std::string shard = "1/1";
    std::uint64_t seed = 1;
    std::string out;
    std::string tune;
    std::vector<double> errors;
};

void print_windows(const std::map<std::string, sweep::Windows>& windows) {
    for (const auto& [variant, counts] : windows) {
        print("%s: %zu windows from %zu trajectories", printable(variant).c_str(), counts.windows,
              counts.trajectories);
        const char* separator = "; states passed over: ";
        for (const auto& [reason, count] : counts.skipped) {
            print("%s%s %zu", separator, printable(reason).c_str(), count);
            separator = ", ";
        }
        print("\n");
    }
}

void print_figures(const std::vector<sweep::Figures>& all) {
    print("\n%-10s %-22s %7s %5s %9s %9s %9s %9s %5s %6s %6s %6s %9s\n", "variant", "contender", "1/dt, Hz",
          "runs", "median", "95 %", "largest", "typical", "exact", "missed", "extra", "failed", "CPU ms/s");
    for (const sweep::Figures& f : all)
        print("%-10s %-22s %7.0f %5zu %9.2e %9.2e %9.2e %9.2e %5zu %6zu %6zu %6zu %9.4g\n",
              printable(f.variant).c_str(), printable(f.contender).c_str(), 1 / f.dt, f.windows, f.median,
              f.p95, f.max, f.typical_median, f.exact, f.missed, f.spurious, f.failed, 1e3 * f.cpu_min);
    print(
        "\nmedian, 95 %%, largest: error of position at the end of a window, in radii, worst ball. typical: "
        "median\nwindow, median of the balls that hit something. exact: windows within 1e-9 radii. missed, "
        "extra: impacts.\nCPU: ms per simulated second; %s.\n",
        lab::libraries().c_str());
}

/// The most frequent first wrong decisions of each contender.
void print_blame(const std::vector<sweep::Figures>& all) {
    print("\nBlame: the first wrong decision of each run that is not exact, over all steps\n");
    constexpr std::size_t enough = 6;
    for (const sweep::BlameShares& one : sweep::blame_shares(all)) {
        print("%s, %s: %zu divergences", printable(one.variant).c_str(), printable(one.contender).c_str(),
              one.divergences);
        for (std::size_t i = 0; i < std::min(enough, one.shares.size()); ++i) {
            const auto& share = one.shares[i];
            const std::string most = share.part.empty() ? "" : " (mostly " + printable(share.part) + ")";
            print("\n  %s%s", sweep::in_words(share, one.divergences).c_str(), most.c_str());
        }
        print(one.shares.size() > enough ? "\n  ...\n" : "\n");
    }
}

FilesOfCommand files_of(const SweepOptions& options) {
    const std::filesystem::path folder = options.out;
    FilesOfCommand files{{},
                         {{"the plan", folder / "plan.json"},
                          {"the summary", folder / "sweep.csv"},
                          {"the blame", folder / "blame.csv"}},
                         true};
    for (const std::string& scene : options.scenes)
        files.inputs.push_back({"the scene", lab::scene_file(scene)});
    return files;
}

/// Settings are searched instead of a sweep.
int tune(const SweepOptions& options) {
    lab::tune::Request request{.engine = &lab::engine_named(options.tune), .seed = options.seed};
    if (!options.errors.empty()) request.targets = options.errors;
    request.finest = options.quick ? std::min(960, options.finest) : options.finest;
    if (options.quick) request.windows = 10;
    const std::filesystem::path folder = options.out;
    FilesOfCommand files{{}, {{"the figures", folder / "tuning.csv"}}, true};
    for (const std::string& scene : options.scenes)
        files.inputs.push_back({"the scene", lab::scene_file(scene)});
    require_distinct(files);
    return run_tuning(request, sweep::variants_of(options.scenes, options.balls), folder);
}

/// Contenders with a step and settings of their own.
void add_defined(sweep::Plan& plan, const std::vector<std::string>& texts) {
    for (const lab::ContenderRequest& request : lab::parse_contenders(texts)) {
        const sweep::Contender& contender = sweep::add_contender(request);
        if (sweep::steps_of(contender, plan).empty())
            throw InputError("contender '" + request.name + "': its step is shorter than the sweep's 1/" +
                             std::to_string(plan.finest) + " s");
        plan.contenders.push_back(&contender);
    }
}

int run_sweep(const SweepOptions& options) {
    if (!options.tune.empty()) return tune(options);
    const sweep::Shard shard = parse_shard(options.shard);
    for (const std::string& engine : options.engines) static_cast<void>(lab::engine_named(engine));
    auto variants = sweep::variants_of(options.scenes, options.balls);
    sweep::Plan plan = options.quick ? sweep::quick_plan(std::move(variants), options.seed)
                                     : sweep::Plan{.variants = std::move(variants), .seed = options.seed};
    plan.finest = std::min(plan.finest, options.finest);
    if (options.every_window) plan.most_work = sweep::unlimited_work;
    if (!options.contenders.empty()) plan.contenders.clear();
    for (const std::string& name : options.contenders) {
        const auto* contender = &sweep::contender_named(name);
        if (std::ranges::find(plan.contenders, contender) != plan.contenders.end())
            throw InputError("--contenders: " + in_quotes(name) +
                             " is there twice; allowed are different ones");
        plan.contenders.push_back(contender);
    }
    add_defined(plan, options.defined);
    const std::filesystem::path folder = options.out;
    require_distinct(files_of(options));
    {
        Progress progress(1);
        sweep::make_runs(
            plan, shard, folder, [&](double share) { progress.at(share); }, say);
    }
    const sweep::Inventory inventory = sweep::take_inventory(plan, folder);
    print_windows(inventory.windows);
    if (!inventory.is_complete) {
        print("Shard %s is done; sweep.csv is written once all runs are there.\n",
              printable(options.shard).c_str());
        return 0;
    }
    const std::vector<sweep::Figures> figures = sweep::summarize(sweep::gather({&folder, 1}));
    sweep::write_summary(folder / "sweep.csv", figures);
    sweep::write_blame(folder / "blame.csv", figures);
    print_figures(figures);
    print_blame(figures);
    return 0;
}

}  // namespace

void add_sweep(CLI::App& program, Action& chosen) {
    auto options = std::make_shared<SweepOptions>();
    CLI::App& command = *program.add_subcommand("sweep",
                                                "Work-precision data: error against the exact outcome, what "
                                                "it begins with, and cost, of every solver and step");
    command.add_option("scenes", options->scenes, "Scenes or files (default: pinball, toy and rain)")
        ->type_name("SCENE");
    command.add_option("--balls", options->balls, "Number of balls fired, or of a generated field")
        ->check(whole_number_from(1, 1'000'000))
        ->type_name("N");
    command
        .add_option("--contenders", options->contenders,
                    "Only these (default: all; plan.json describes them); libraries by their paths")
        ->delimiter(',')
        ->type_name("A,B");
    command
        .add_option("--contender", options->defined,
                    "And this one, with settings and, if it says so, a step of its own; given once for each")
        ->type_name("NAME=E[,dt=H][,K=V]...");
    add_libraries(command, options->engines);
    command.add_option("--finest", options->finest, "Steps per second at most (default 7680)")
        ->check(whole_number_from(sweep::coarsest_steps, sweep::finest_steps))
        ->type_name("N");
    command.add_flag("--quick", options->quick, "Fewer windows, and no step below 1/960 s");
    CLI::Option* every_window =
        command.add_flag("--every-window", options->every_window,
                         "Also those that are left out otherwise, where many balls take many steps");
    command.add_option("--shard", options->shard, "Only the K-th of N parts; in any order, at the same time")
        ->type_name("K/N");
    command.add_option("--seed", options->seed, "Of the windows (default 1)")
        ->check(whole_number_from(0, sweep::largest_seed))
        ->type_name("S");
    command
        .add_option("--tune", options->tune,
                    "Instead of a sweep, search this engine's cheapest settings and step for each scene")
        ->excludes("--contenders")
        ->excludes("--contender")
        ->excludes("--engine")
        ->excludes("--shard")
        ->excludes(every_window)
        ->type_name("ENGINE");
    command
        .add_option("--error", options->errors,
                    "With --tune: the errors that are allowed, in radii (default 0.1,0.01,0.001)")
        ->needs("--tune")
        ->check(number_from(1e-13, 10))
        ->delimiter(',')
        ->type_name("E,E");
    command.add_option("--out", options->out, "Folder of the data; what is finished there is not done again")
        ->required()
        ->type_name("DIR");
    command.callback([options, &chosen] { chosen = [options] { return run_sweep(*options); }; });
}

}  // namespace flipside::app

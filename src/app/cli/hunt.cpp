#include "lab/hunt/hunt.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "app/cli/commands.hpp"
#include "app/cli/distinct_files.hpp"
#include "app/cli/output.hpp"
#include "app/cli/progress.hpp"
#include "app/cli/run_options.hpp"
#include "app/cli/shard.hpp"
#include "lab/contenders/engines.hpp"
#include "lab/files/assets.hpp"
#include "world/input_error.hpp"
#include "world/json_file.hpp"
#include "world/printable.hpp"
#include "world/scene_file.hpp"

namespace flipside::app {

namespace {

namespace hunts = lab::hunt;

struct HuntOptions {
    std::string contender, engine, goal = "overlap", dt = "1/60", shard = "1/1", out, replay;
    std::optional<double> seconds, length;
    std::uint64_t seed = 1;
    std::optional<std::size_t> scenes, rounds;
};

lab::ContenderRequest contender_of(const HuntOptions& options) {
    if (options.contender.empty()) return lab::plain_contender(lab::engine_named(options.engine));
    const std::string texts[] = {options.contender};
    return lab::parse_contenders(texts).front();
}

constexpr std::size_t most_rounds = 999;

/// Scenes that each round looks at. A short budget is for short rounds.
std::size_t scenes_of(const HuntOptions& options) {
    constexpr std::size_t usual = 2000, few = 100;
    constexpr double long_budget = 600;  // s
    return options.scenes.value_or(options.seconds.value_or(long_budget) < long_budget ? few : usual);
}

/// The rounds of a budget follow from a nominal time of a scene on one core. No clock decides, so that the
/// same options give the same bytes.
std::size_t rounds_of(const HuntOptions& options) {
    constexpr std::size_t usual = 4;
    if (options.rounds || !options.seconds) return options.rounds.value_or(usual);
    const bool with_reference = hunts::goal_named(options.goal) == hunts::Goal::error;
    const double each = with_reference ? 0.03 : 0.002;  // s
    const double rounds = *options.seconds / (each * static_cast<double>(scenes_of(options)));
    return static_cast<std::size_t>(std::clamp(std::round(rounds), 1.0, static_cast<double>(most_rounds)));
}

/// Of each run, s. Files of earlier hunts say --seconds where a scene is shown again, which needs no budget.
double length_of(const HuntOptions& options) {
    constexpr double usual = 1;
    return options.length.value_or(options.replay.empty() ? usual : options.seconds.value_or(usual));
}

hunts::Request request_of(const HuntOptions& options) {
    if (options.contender.empty() == options.engine.empty())
        throw InputError("hunt: needs --engine or --contender, and not both");
    return {contender_of(options),
            lab::parse_step(options.dt),
            hunts::goal_named(options.goal),
            length_of(options),
            options.seed,
            scenes_of(options),
            rounds_of(options)};
}

int replay(const HuntOptions& options) {
    const Scene scene = load_scene(lab::scene_file(options.replay));
    const hunts::Request request = request_of(options);
    if (!hunts::says_something(request.goal, scene))
        throw InputError("--goal " + options.goal + " says nothing of scene " + in_quotes(scene.name) +
                         ": something moves or gives energy there by itself");
    const hunts::Measured measured = measure(request, scene);
    print("%s\n", printable(hunts::sentence(request, measured)).c_str());
    return 0;
}

void print_found(const hunts::Request& request, const std::vector<hunts::Found>& all,
                 const std::string& folder) {
    for (const hunts::Found& found : all)
        print("%s (%zu balls, %zu parts)\n", printable(hunts::sentence(request, found.measured)).c_str(),
              found.balls, found.parts);
    print("The first is %s.\n", printable((std::filesystem::path(folder) / "worst.json").string()).c_str());
}

int hunt(const HuntOptions& options) {
    if (options.out.empty() == options.replay.empty())
        throw InputError("hunt: needs --out or --replay, and not both");
    if (!options.replay.empty()) return replay(options);
    const hunts::Request request = request_of(options);
    const lab::sweep::Shard shard = parse_shard(options.shard);
    std::optional<std::vector<hunts::Found>> all;
    {
        Progress progress(1);
        all = hunts::hunt(
            request, shard, options.out, [&](double share) { progress.at(share); }, say);
    }
    if (all)
        print_found(request, *all, options.out);
    else
        print("Shard %s is done; worst.json is written once all rounds are there.\n",
              printable(options.shard).c_str());
    return 0;
}

}  // namespace

void add_hunt(CLI::App& program, Action& chosen) {
    auto options = std::make_shared<HuntOptions>();
    CLI::App& command = *program.add_subcommand(
        "hunt", "Search scenes on which an engine is at its worst, and shrink what is found");
    command
        .add_option("--engine", options->engine,
                    "Whose worst is hunted: an engine as it comes (see `flipside engines`)")
        ->type_name("E");
    command.add_option("--contender", options->contender, "Or an engine with a step and settings of its own")
        ->type_name("NAME=E[,dt=H][,K=V]...");
    command
        .add_option(
            "--goal", options->goal,
            "overlap, energy (gained), escape or lost (balls lost), error (against the reference), work "
            "or time (tests per ball and step, which take it)")
        ->capture_default_str()
        ->type_name("GOAL");
    command.add_option("--length", options->length, "Length of each run, s (default 1)")
        ->check(number_from(1e-3, 60))
        ->type_name("T");
    command.add_option("--dt", options->dt, "Step, s, as 0.01 or 1/60")
        ->capture_default_str()
        ->type_name("H");
    command
        .add_option(
            "--scenes", options->scenes,
            "Scenes that each round looks at: half of them random, half climbing (default 2000, for a "
            "budget below 600 s 100)")
        ->check(whole_number_from(1, 10'000'000))
        ->type_name("N");
    command
        .add_option("--rounds", options->rounds,
                    "Rounds, each from other random scenes (default 4, or by --seconds)")
        ->check(whole_number_from(1, most_rounds))
        ->type_name("N");
    command
        .add_option(
            "--seconds", options->seconds,
            "In place of --rounds, as many as this gives at a nominal 2 ms a scene, s (30 ms with error); "
            "the real time may be a tenth of it or seven times as much")
        ->excludes("--rounds")
        ->check(number_from(1e-3, 1e6))
        ->type_name("BUDGET");
    command.add_option("--shard", options->shard, "Only the K-th of N parts; in any order, at the same time")
        ->type_name("K/N");
    command.add_option("--seed", options->seed, "Of the scenes (default 1)")
        ->check(whole_number_from(0, 1'000'000'000'000))
        ->type_name("S");
    command
        .add_option("--out", options->out,
                    "Folder of what is found; what is finished there is not done again")
        ->type_name("DIR");
    command.add_option("--replay", options->replay, "Instead of a hunt: how bad it is on this scene")
        ->excludes("--scenes")
        ->excludes("--rounds")
        ->excludes("--seed")
        ->excludes("--shard")
        ->type_name("SCENE");
    command.callback([options, &chosen] { chosen = [options] { return hunt(*options); }; });
}

}  // namespace flipside::app

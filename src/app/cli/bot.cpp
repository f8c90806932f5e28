#include "app/cli/commands.hpp"
#include "app/cli/output.hpp"
#include "app/cli/output_file.hpp"
#include "app/cli/progress.hpp"
#include "app/cli/run_options.hpp"
#include "lab/bot/figures.hpp"
#include "lab/contenders/recommended.hpp"
#include "lab/files/assets.hpp"
#include "lab/files/whole_file.hpp"
#include "world/input_error.hpp"
#include "world/printable.hpp"
#include "world/scene_file.hpp"

namespace flipside::app {

namespace {

namespace bots = lab::bot;

struct BotOptions {
    std::string scene = "pinball", engine, dt, out, replays;
    std::vector<std::string> settings;
    std::size_t games = 200;
    std::uint64_t seed = 1;
};

bots::Request bot_request(const BotOptions& options) {
    const auto scene = std::make_shared<const Scene>(load_scene(lab::scene_file(options.scene)));
    bots::require_playable(*scene);
    const Engine& engine = lab::engine_named(options.engine);
    lab::require_known_engines(*scene);
    return {scene, &engine, settings_with(options.settings, engine, *scene),
            options.dt.empty() ? lab::step_for(*scene) : lab::parse_step(options.dt)};
}

void print_spread(const char* what, const bots::Spread& spread, const char* unit) {
    print("%-10s median %.0f%s, half of them from %.0f to %.0f, greatest %.0f\n", what, spread.median, unit,
          spread.quarter, spread.three_quarters, spread.greatest);
}

void print_figures(const bots::Figures& figures, std::size_t games) {
    print_spread("time", figures.seconds, " s");
    print_spread("score", figures.score, "");
    print("%-10s %zu of %zu\n", "unfinished", figures.unfinished, games);
    print("%-10s %ld drained, %llu lost otherwise\n", "balls", figures.lost,
          static_cast<unsigned long long>(figures.strays));
    print("%-10s %d still for 10 s; the longest time was %.1f s; the table sought a ball %d times\n", "stuck",
          figures.stuck, figures.longest_still, figures.searches);
    print("%-10s", "drained");
    const char* separator = " ";
    for (const auto& [name, count] : figures.drained_after) {
        print("%s%.0f %% after %s", separator,
              100.0 * count / static_cast<double>(std::max(1L, figures.lost)),
              name.empty() ? "nothing" : printable(name).c_str());
        separator = ", ";
    }
    print("\n");
}

/// A game that somebody saved is never replaced.
void require_new_replays(const BotOptions& options) {
    namespace fs = std::filesystem;
    const fs::path out = options.out.empty() ? fs::path() : fs::weakly_canonical(options.out);
    for (std::uint64_t game = 0; game < options.games; ++game) {
        const fs::path file = bots::replay_file(options.replays, options.seed + game);
        if (fs::exists(file) || fs::weakly_canonical(file) == out)
            throw InputError("--replays would write '" + file.string() +
                             "', which is another file already; allowed is a folder without it");
    }
}

int play_games(const BotOptions& options) {
    bots::Request request = bot_request(options);
    require_distinct({{{"the scene", lab::scene_file(options.scene)}},
                      {{"--out", options.out}, {"--replays", options.replays}},
                      true});
    if (!options.replays.empty()) {
        require_new_replays(options);
        lab::make_folder(options.replays);
        request.replays = options.replays;
    }
    OutputFile table(options.out);
    std::vector<bots::Played> games;
    {
        Progress progress(static_cast<double>(options.games));
        games = bots::play(request, options.seed, options.games,
                           [&](std::size_t done) { progress.at(static_cast<double>(done)); });
    }
    if (auto* out = table.out()) {
        *out << bots::games_header;
        bots::write_games(*out, games);
    }
    table.finish();
    print_figures(bots::figures_of(games), games.size());
    return 0;
}

}  // namespace

void add_bot(CLI::App& program, Action& chosen) {
    auto options = std::make_shared<BotOptions>();
    CLI::App& command =
        *program.add_subcommand("bot", "Let a bot play whole games on one engine; prints what they come to");
    command.add_option("scene", options->scene, "A name (see `flipside scenes`) or the path of a scene file")
        ->capture_default_str()
        ->type_name("SCENE");
    command.add_option("--engine", options->engine, "The engine (see `flipside engines`)")
        ->required()
        ->type_name("E");
    command.add_option("--games", options->games, "How many")
        ->check(whole_number_from(1, 1'000'000))
        ->capture_default_str()
        ->type_name("N");
    command.add_option("--seed", options->seed, "Of the first game; the next ones follow")
        ->check(whole_number_from(0, 1'000'000'000'000))
        ->capture_default_str()
        ->type_name("S");
    command
        .add_option("--dt", options->dt,
                    "Step, s, as 0.01 or 1/60 (default: what the scene recommends, or 1/60)")
        ->type_name("H");
    command
        .add_option("--set", options->settings,
                    "A setting (see `flipside engines`); may be given several times")
        ->allow_extra_args(false)
        ->type_name("K=V");
    command.add_option("--out", options->out, "A row per game: score, time, balls, stuck ones")
        ->type_name("CSV");
    command
        .add_option("--replays", options->replays,
                    "Save each game there, as game-SEED.flipside-replay (see `flipside replay`)")
        ->type_name("DIR");
    command.callback([options, &chosen] { chosen = [options] { return play_games(*options); }; });
}

}  // namespace flipside::app

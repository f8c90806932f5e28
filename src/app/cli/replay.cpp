#include "app/cli/commands.hpp"
#include "app/cli/output.hpp"
#include "app/cli/progress.hpp"
#include "lab/contenders/engines.hpp"
#include "lab/process/failure.hpp"
#include "lab/replay/play.hpp"
#include "world/printable.hpp"

namespace flipside::app {

namespace {

struct ReplayOptions {
    std::string file;
    std::string engine;  ///< "": as it was played
};

void play_to_end(lab::ReplayPlayer& player, double seconds) {
    Progress progress(seconds);
    while (player.step()) progress.at(player.session().world().time());
}

/// All runs as they were; says of each whether it is the same to the bit.
int check_replay(const lab::Replay& replay) {
    bool same = true;
    for (std::size_t i = 0; i < replay.runs.size(); ++i) {
        const lab::ReplayRun& run = replay.runs[i];
        lab::ReplayPlayer player(replay, i);
        play_to_end(player, run.end.time);
        const auto& parting = player.parting();
        same = same && !parting;
        print("%s: steps %llu, %.6g s, score %ld: ", run.name.c_str(),
              static_cast<unsigned long long>(player.session().recording().steps()),
              player.session().world().time(), player.session().game().score());
        if (parting)
            print("another way than the game, whose score is %ld, from between %.6g s and %.6g s on\n",
                  run.end.score, parting->after, parting->before);
        else
            print("the same to the bit\n");
    }
    if (!same)
        throw lab::Failure("the replay is not the game that was saved, by " + printable(replay.program));
    return 0;
}

/// The first run's hands on another engine.
int play_on_another(const lab::Replay& replay, const Engine& engine) {
    const lab::ReplayRun& run = replay.runs.front();
    lab::ReplayPlayer player(replay, 0, engine);
    play_to_end(player, run.end.time);
    print("%s as played on %s: steps %llu, %.6g s, score %ld; there it was %ld\n",
          printable(std::string(engine.name)).c_str(), run.name.c_str(),
          static_cast<unsigned long long>(player.session().recording().steps()),
          player.session().world().time(), player.session().game().score(), run.end.score);
    return 0;
}

int replay_file(const ReplayOptions& options) {
    const lab::Replay replay = lab::load_replay(options.file);
    return options.engine.empty() ? check_replay(replay)
                                  : play_on_another(replay, lab::engine_named(options.engine));
}

}  // namespace

void add_replay(CLI::App& program, Action& chosen) {
    auto options = std::make_shared<ReplayOptions>();
    CLI::App& command = *program.add_subcommand(
        "replay", "Play a saved game again, and say whether it is the same to the bit");
    command.add_option("file", options->file, "What the window saved (F5)")->required()->type_name("FILE");
    command
        .add_option("--engine", options->engine,
                    "Play it on this engine instead: the same hands, as far as the rules let them")
        ->type_name("E");
    command.callback([options, &chosen] { chosen = [options] { return replay_file(*options); }; });
}

}  // namespace flipside::app

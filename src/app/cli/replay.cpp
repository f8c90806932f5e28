#include "app/cli/commands.hpp"
#include "app/cli/display.hpp"
#include "app/cli/output.hpp"
#include "app/cli/progress.hpp"
#include "app/cli/run_options.hpp"
#include "app/cli/view_options.hpp"
#include "app/film/export.hpp"
#include "app/film/ffmpeg.hpp"
#include "app/render.hpp"
#include "lab/contenders/engines.hpp"
#include "lab/process/failure.hpp"
#include "lab/replay/play.hpp"
#include "world/input_error.hpp"
#include "world/printable.hpp"

namespace flipside::app {

namespace {

struct ReplayOptions {
    std::string file;
    std::string engine;  ///< "": as it was played
    film::ExportOptions film;
    std::optional<View> view;
    std::vector<std::string> show;
};

void play_to_end(lab::ReplayPlayer& player, double seconds) {
    Progress progress(seconds);
    while (player.step()) progress.at(player.session().world().time());
}

[[noreturn]] void fail_of_parting(const lab::Replay& replay) {
    throw lab::Failure("the replay is not the game that was saved, by " + printable(replay.program));
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
    if (!same) fail_of_parting(replay);
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

/// Pictures, a video, sound.
int make_film(const lab::Replay& replay, const Engine* other, const ReplayOptions& options) {
    film::ExportOptions film = options.film;
    film.view =
        options.view.value_or(replay.runs.size() > 1 && other == nullptr ? View::split : View::single);
    film.look.shows = parse_shows(options.show);
    if (!film.video.empty() && (film.width % 2 != 0 || film.height % 2 != 0))
        throw InputError("--width and --height: " + std::to_string(film.width) + " x " +
                         std::to_string(film.height) + "; a video takes even numbers");
    if (!film.video.empty()) film::require_ffmpeg();
    if (!film.video.empty() || !film.frames.empty()) require_display();
    film::Exported exported;
    {
        Progress progress(1);
        exported = film::export_film(replay, other, film, [&](double share) { progress.at(share); });
    }
    print("%llu frames, %.6g s\n", static_cast<unsigned long long>(exported.frames), exported.seconds);
    if (!exported.parted.empty()) fail_of_parting(replay);
    return 0;
}

int replay_file(const ReplayOptions& options) {
    const film::ExportOptions& film = options.film;
    require_distinct({{{"the replay", options.file}},
                      {{"--frames", film.frames}, {"--video", film.video}, {"--sound", film.sound}}});
    const bool films = !film.frames.empty() || !film.video.empty() || !film.sound.empty();
    const lab::Replay replay = lab::load_replay(options.file);
    if (films)
        return make_film(replay, options.engine.empty() ? nullptr : &lab::engine_named(options.engine),
                         options);
    return options.engine.empty() ? check_replay(replay)
                                  : play_on_another(replay, lab::engine_named(options.engine));
}

/// Throws where something is said of a film that is not asked for: nothing is ignored.
void require_film(const CLI::App& command) {
    const auto is_given = [&](const char* option) { return command.get_option(option)->count() > 0; };
    if (is_given("--frames") || is_given("--video") || is_given("--sound")) return;
    for (const char* option :
         {"--from", "--to", "--fps", "--view", "--show", "--no-artwork", "--width", "--height"})
        if (is_given(option))
            throw InputError(std::string(option) +
                             " is said of a film: --frames, --video or --sound asks for one");
}

}  // namespace

void add_replay(CLI::App& program, Action& chosen) {
    auto options = std::make_shared<ReplayOptions>();
    CLI::App& command = *program.add_subcommand(
        "replay", "Play a saved game again: is it the same to the bit? Or make a film of it");
    command.add_option("file", options->file, "What the window saved (F5)")->required()->type_name("FILE");
    command
        .add_option("--engine", options->engine,
                    "Play it on this engine instead: the same hands, as far as the rules let them")
        ->type_name("E");
    film::ExportOptions& film = options->film;
    command
        .add_option("--frames", film.frames,
                    "Write every frame into this folder as a PNG file, and sound.wav")
        ->type_name("DIR");
    command.add_option("--video", film.video, "Write a video with sound, by ffmpeg")->type_name("MP4");
    command.add_option("--sound", film.sound, "Write the sound alone")->type_name("WAV");
    command.add_option("--fps", film.frames_per_second, "Frames per second of the game (default 60)")
        ->check(whole_number_from(1, 240))
        ->type_name("N");
    command.add_option("--from", film.part.from, "Where the film begins, s of the game (default 0)")
        ->check(number_from(0, 1e7))
        ->type_name("T");
    command.add_option("--to", film.part.to, "Where it ends (default the end of the game)")
        ->check(number_from(0, 1e7))
        ->type_name("T");
    add_view(command, options->view, "split where there are several runs");
    command.add_option("--show", options->show, "What to draw of the engines' insides: boxes,cells,...")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->type_name("A,B,...");
    command.add_flag("!--no-artwork", film.look.artwork, "Parts and balls alone, on a plain ground");
    add_size(command, film.width, film.height);
    command.callback([options, &command, &chosen] {
        require_film(command);
        chosen = [options] { return replay_file(*options); };
    });
}

}  // namespace flipside::app

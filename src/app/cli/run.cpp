#include "lab/session/run.hpp"

#include "app/cli/commands.hpp"
#include "app/cli/output.hpp"
#include "app/cli/output_file.hpp"
#include "app/cli/progress.hpp"
#include "app/cli/run_options.hpp"
#include "lab/files/csv.hpp"
#include "lab/process/failure.hpp"
#include "lab/replay/replay.hpp"
#include "lab/session/run_figures.hpp"
#include "world/input_error.hpp"
#include "world/state_file.hpp"

namespace flipside::app {

namespace {

struct SingleRunOptions : RunOptions {
    std::string engine;
    std::string from, out, events, stats, save, replay;  ///< files; "" where not asked for
    std::uint64_t every = 1;

    [[nodiscard]] FilesOfCommand files() const {
        FilesOfCommand files{inputs(),
                             {{"--out", out},
                              {"--events", events},
                              {"--stats", stats},
                              {"--save", save},
                              {"--replay", replay}}};
        files.inputs.push_back({"--from", from});
        return files;
    }
};

lab::Session make_session(const SingleRunOptions& options, const std::shared_ptr<const Scene>& scene) {
    const Engine& engine = lab::engine_named(options.engine);
    lab::Session session(scene, engine, settings_with(options.settings, engine, *scene));
    restore_from(options.from, session);
    return session;
}

lab::Replay replay_of(const lab::Session& session, double dt) {
    const lab::RecordedRun recorded{std::string(session.engine().name), &session, dt};
    return lab::replay_of({&recorded, 1});
}

/// What keeps a run from becoming a replay (a state that it starts from, a library) is known before it.
void require_replay(const lab::Session& session, double dt) {
    try {
        static_cast<void>(replay_of(session, dt));
    } catch (const lab::Failure& failure) {
        throw InputError(std::string("--replay: ") + failure.what());
    }
}

int run_scene(const SingleRunOptions& options) {
    static_cast<void>(lab::engine_named(options.engine));
    require_distinct(options.files());
    const auto scene = options.load();
    lab::Session session = make_session(options, scene);
    const lab::Timeline timeline(session.world().time(), options.seconds, options.step(*scene));
    const Script script = options.load_script(*scene);
    if (!options.replay.empty()) require_replay(session, timeline.dt());

    OutputFile trajectory(options.out), events(options.events), stats(options.stats), save(options.save),
        replay(options.replay);
    if (auto* out = events.out()) *out << lab::events_header;
    if (auto* out = trajectory.out()) {
        *out << lab::trajectory_header;
        lab::write_sample(*out, timeline.start(), session.world().balls());
    }
    const double energy_first = lab::energy(session.world(), *scene);
    {
        Progress progress(options.seconds);
        const auto after = [&](const lab::Session& now, std::uint64_t step, double time) {
            const bool sampled = (step + 1) % options.every == 0 || step + 1 == timeline.steps();
            if (auto* out = trajectory.out(); out && sampled)
                lab::write_sample(*out, time, now.world().balls());
            if (auto* out = events.out()) lab::write_events(*out, now.events(), *scene);
            progress.at(time - timeline.start());
        };
        lab::run({&session, 1}, timeline, script, after);
    }
    const std::string figures = to_json(lab::figures_of(session, options.seconds, energy_first));
    if (auto* out = stats.out()) *out << figures;
    if (auto* out = save.out()) *out << to_json(session.world().save(), *scene);
    if (auto* out = replay.out()) *out << to_json(replay_of(session, timeline.dt()));
    bool silent = true;
    for (OutputFile* file : {&trajectory, &events, &stats, &save, &replay}) {
        silent &= file->out() == nullptr;
        file->finish();
    }
    if (silent) print_text(figures);
    return 0;
}

}  // namespace

void add_run(CLI::App& program, Action& chosen) {
    auto options = std::make_shared<SingleRunOptions>();
    CLI::App& command = *program.add_subcommand(
        "run", "Run a scene on one engine; prints its figures where no file is asked for");
    options->add_to(command, "K=V");
    options->add_seconds(command);
    command.add_option("--engine", options->engine, "The engine (see `flipside engines`)")
        ->required()
        ->type_name("E");
    command
        .add_option("--from", options->from,
                    "Start from a state of the same table that --save wrote, on any engine")
        ->type_name("STATE");
    command.add_option("--out", options->out, "Trajectory: time,ball,x,y,vx,vy,angle,spin")->type_name("CSV");
    command.add_option("--every", options->every, "Sample the trajectory every N steps (default 1)")
        ->needs("--out")
        ->check(whole_number_from(1, 1'000'000'000))
        ->type_name("N");
    command.add_option("--events", options->events, "Events: time,kind,ball,other,x,y,nx,ny,speed,impulse")
        ->type_name("CSV");
    command.add_option("--stats", options->stats, "Figures of the run: cost, energy, impacts, lost balls")
        ->type_name("JSON");
    command.add_option("--save", options->save, "State at the end, to go on from with --from")
        ->type_name("STATE");
    command.add_option("--replay", options->replay, "All of the run, for `flipside replay`")
        ->type_name("FILE");
    command.callback([options, &chosen] { chosen = [options] { return run_scene(*options); }; });
}

}  // namespace flipside::app

#include <limits>

#include "app/cli/commands.hpp"
#include "app/cli/output.hpp"
#include "app/cli/output_file.hpp"
#include "app/cli/progress.hpp"
#include "app/cli/run_options.hpp"
#include "lab/session/run.hpp"
#include "lab/session/traced_step.hpp"
#include "world/input_error.hpp"
#include "world/json_file.hpp"

namespace flipside::app {

namespace {

struct TraceOptions : RunOptions {
    std::string engine, from, json;  ///< files: "" where not asked for
    double at = 0;                   ///< s
    std::optional<BallNumber> ball;
};

void require_ball(BallNumber ball, const lab::TracedStep& step, std::span<const Ball> before,
                  std::span<const Ball> after) {
    const auto is_there = [&](std::span<const Ball> balls) {
        return std::ranges::find(balls, ball, &Ball::number) != balls.end();
    };
    if (is_there(before) || is_there(after)) return;
    throw InputError("--ball " + std::to_string(ball) + ": there is no such ball in the step from " +
                     brief(step.time) + " s; there are " +
                     names_of(before, [](const Ball& one) { return std::to_string(one.number); }));
}

int trace(const TraceOptions& options) {
    FilesOfCommand files{options.inputs(), {{"--json", options.json}}};
    files.inputs.push_back({"--from", options.from});
    const Engine& engine = lab::engine_named(options.engine);
    require_distinct(files);
    const auto scene = options.load();
    lab::Session session(scene, engine, settings_with(options.settings, engine, *scene));
    restore_from(options.from, session);
    const double start = session.world().time();
    if (options.at < start)
        throw InputError("--at " + brief(options.at) + ": the state is of " + brief(start) +
                         " s already; it takes a later time");
    const double dt = options.step(*scene);
    const Script script = options.load_script(*scene);
    const lab::Timeline timeline(start, options.at - start, dt);
    OutputFile json(options.json);
    {
        Progress progress(options.at - start);
        lab::run({&session, 1}, timeline, script, [&](const lab::Session&, std::uint64_t, double time) {
            progress.at(time - timeline.start());
        });
    }
    const std::vector<Ball> before(session.world().balls().begin(), session.world().balls().end());
    std::size_t next = lab::next_control(script, session.world().time());
    lab::TracedStep step = lab::trace_step(session, dt, script, next);
    if (options.ball) {
        require_ball(*options.ball, step, before, session.world().balls());
        lab::keep_ball(step.trace, *options.ball);
    }
    if (auto* out = json.out())
        *out << lab::to_json(step);
    else
        print_text(lab::to_text(step));
    json.finish();
    return 0;
}

}  // namespace

void add_trace(CLI::App& program, Action& chosen) {
    auto options = std::make_shared<TraceOptions>();
    CLI::App& command =
        *program.add_subcommand("trace", "Say what an engine does inside one step, stage by stage");
    options->add_to(command, "K=V");
    command.add_option("--engine", options->engine, "The engine (see `flipside engines`)")
        ->required()
        ->type_name("E");
    command.add_option("--at", options->at, "When the step begins, s (default 0)")
        ->check(number_from(0, 1e7))
        ->type_name("T");
    command.add_option("--ball", options->ball, "Only what concerns this ball")
        ->check(whole_number_from(0, std::numeric_limits<BallNumber>::max()))
        ->type_name("K");
    command
        .add_option("--from", options->from,
                    "Start from a state of the same table that `run --save` wrote, on any engine")
        ->type_name("STATE");
    command.add_option("--json", options->json, "Write it to a file as JSON instead")->type_name("FILE");
    command.callback([options, &chosen] { chosen = [options] { return trace(*options); }; });
}

}  // namespace flipside::app

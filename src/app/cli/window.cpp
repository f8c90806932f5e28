#include <algorithm>

#include "app/cli/commands.hpp"
#include "app/cli/display.hpp"
#include "app/cli/run_options.hpp"
#include "app/cli/view_options.hpp"
#include "app/play.hpp"
#include "app/render.hpp"
#include "app/window/layout.hpp"
#include "lab/files/assets.hpp"
#include "lab/files/whole_file.hpp"
#include "lab/lessons/lesson.hpp"
#include "world/input_error.hpp"
#include "world/script_file.hpp"

namespace flipside::app {

namespace {

constexpr const char* default_scene = "pinball";

struct RenderArguments {
    RenderOptions options;
    std::string dt, script;  ///< as on the command line
    std::filesystem::path out;
};

/// "NAME=VALUE" means the chosen engine.
void name_engine(std::vector<std::string>& settings, const Engine& engine) {
    for (std::string& text : settings)
        if (text.substr(0, text.find('=')).find('.') == std::string::npos)
            text = std::string(engine.name) + "." + text;
}

/// Says on stderr which settings have no effect. Without contenders the engines take part as they are.
void note_idle_settings(const std::vector<std::string>& settings, const std::vector<std::string>& contenders,
                        const Scene& scene) {
    auto requests = lab::parse_contenders(contenders);  // loads the libraries among them
    const auto changes = lab::parse_changes(settings, lab::engines());
    if (requests.empty())
        for (const Engine* engine : lab::engines())
            if (std::ranges::find(changes, engine, &lab::SettingChange::engine) != changes.end())
                requests.push_back(lab::plain_contender(*engine));
    note_idle(requests, scene, changes);
}

/// What is wrong with the input is said without a display too.
void check_play(const PlayOptions& options) {
    if (!options.engine.empty()) static_cast<void>(lab::engine_named(options.engine));
    RunOptions run;
    run.scene = options.scene.value_or(default_scene);
    const auto scene = run.load();
    if (options.script) static_cast<void>(load_script(*options.script, *scene));
    note_idle_settings(options.settings, options.contenders,
                       options.lesson ? *lab::load_lesson(*options.lesson).scene : *scene);
}

int render(RenderArguments arguments) {
    RenderOptions& options = arguments.options;
    RunOptions run;
    run.scene = options.scene;
    run.dt = arguments.dt;
    run.script = arguments.script;
    name_engine(options.settings, lab::engine_named(options.engine));
    require_distinct({run.inputs(), {{"--out", arguments.out}}});
    if (arguments.out.extension() != ".png")
        throw InputError("--out '" + arguments.out.string() +
                         "' is no name of a picture; allowed is one as x.png");
    const auto scene = run.load();
    options.dt = run.step(*scene);
    options.script = run.script_path();
    static_cast<void>(parse_shows(options.show));
    static_cast<void>(run.load_script(*scene));
    note_idle_settings(options.settings, {}, *scene);
    lab::WholeFile picture(arguments.out);
    require_display();
    picture.out() << render(options);
    picture.finish();
    return 0;
}

}  // namespace

void add_play(CLI::App& program, Action& chosen) {
    auto options = std::make_shared<PlayOptions>();
    CLI::App& command = *program.add_subcommand("play", "Open the window (also without any command)");
    command.add_option("scene", options->scene, "A name (see `flipside scenes`) or a file (default pinball)")
        ->type_name("SCENE");
    CLI::Option* engine =
        command.add_option("--engine", options->engine, "The engine of the single view (default custom)")
            ->type_name("E");
    add_contenders(command, options->contenders)->excludes(engine);
    command
        .add_option_function<std::string>(
            "--dt", [options](const std::string& dt) { options->dt = lab::parse_step(dt); },
            "Step, s, as 0.01 or 1/60 (default: what the scene recommends, or 1/60)")
        ->type_name("H");
    add_view(command, options->view, "split");
    command.add_option("--set", options->settings, "A setting; may be given several times")
        ->allow_extra_args(false)
        ->type_name("E.K=V");
    command.add_option("--script", options->script, "Controls to apply from the start")->type_name("FILE");
    command
        .add_option_function<std::string>(
            "--lesson", [options](const std::string& name) { options->lesson = lab::lesson_file(name); },
            "Open a lesson (see `flipside lessons`) instead of the scene")
        ->type_name("LESSON");
    command.add_option("--report", options->report, "Write the window's state there, a JSON line a frame")
        ->type_name("FILE");
    command
        .add_option("--scale", options->scale,
                    "Size of letters and controls, 0.75 to 3 (default: as suits display and window)")
        ->check(number_from(least_scale, most_scale))
        ->type_name("X");
    command.add_flag("!--no-settings", options->keep,
                     "Neither begin with what was kept of the last start nor keep anything");
    command.add_option("--screenshots", options->screenshots, "Folder for the pictures that F12 takes")
        ->type_name("DIR");
    add_size(command, options->width, options->height);
    command.callback([options, &chosen] {
        chosen = [options] {
            require_distinct({{{"the scene", lab::scene_file(options->scene.value_or(default_scene))},
                               {"the script", options->script.value_or("")}},
                              {{"--report", options->report.value_or("")}}});
            check_play(*options);
            require_display();
            return play(*options);
        };
    });
}

void add_render(CLI::App& program, Action& chosen) {
    auto arguments = std::make_shared<RenderArguments>();
    RenderOptions& options = arguments->options;
    CLI::App& command = *program.add_subcommand("render", "Write a picture of a scene at a moment");
    command.add_option("scene", options.scene, "A name (see `flipside scenes`) or a file")
        ->required()
        ->type_name("SCENE");
    command.add_option("--engine", options.engine, "The engine")->required()->type_name("E");
    command.add_option("--at", options.at, "The moment, s (default 0)")
        ->check(number_from(0, 1e6))
        ->type_name("T");
    command.add_option("--dt", arguments->dt, "Step, s, as 0.01 or 1/60 (default: as in run)")
        ->type_name("H");
    command.add_option("--out", arguments->out, "The picture")->required()->type_name("PNG");
    add_view(command, options.view, "single");
    command.add_option("--show", options.show, "What to draw of the engine's insides: boxes,cells,...")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->type_name("A,B,...");
    command.add_flag("!--no-artwork", options.artwork, "Parts, lamps and balls alone, on a plain ground");
    command.add_option("--set", options.settings, "A setting; may be given several times")
        ->allow_extra_args(false)
        ->type_name("E.K=V");
    command.add_option("--script", arguments->script, "Controls to apply (default: as in run)")
        ->type_name("FILE");
    add_size(command, options.width, options.height);
    command.callback([arguments, &chosen] { chosen = [arguments] { return render(*arguments); }; });
}

}  // namespace flipside::app

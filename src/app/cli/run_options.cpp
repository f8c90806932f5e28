#include "app/cli/run_options.hpp"

#include <charconv>
#include <iomanip>

#include "app/cli/output.hpp"
#include "lab/contenders/recommended.hpp"
#include "lab/files/assets.hpp"
#include "world/input_error.hpp"
#include "world/scene_file.hpp"
#include "world/script_file.hpp"
#include "world/state_file.hpp"

namespace flipside::app {

namespace {

/// In decimal digits: CLI11 would read "0x10" as 16, and "010" as 8.
template <class Number>
std::optional<Number> number_of(const std::string& text) {
    Number value{};
    const char* const end = text.data() + text.size();
    const auto [read, error] = std::from_chars(text.data(), end, value);
    const bool octal = std::is_integral_v<Number> && text.size() > 1 && text[0] == '0';
    return error == std::errc{} && read == end && !octal ? std::optional(value) : std::nullopt;
}

template <class Number>
CLI::Validator within(Number min, Number max, const char* what) {
    const auto check = [=](const std::string& text) -> std::string {
        if (const auto value = number_of<Number>(text); value && *value >= min && *value <= max) return "";
        std::ostringstream problem;
        problem << std::setprecision(16) << "'" << text << "' is not allowed; it takes a " << what << " from "
                << min << " to " << max;
        return problem.str();
    };
    return {check, "", what};
}

}  // namespace

CLI::Validator number_from(double min, double max) {
    return within(min, max, "number");
}

CLI::Validator whole_number_from(std::int64_t min, std::int64_t max) {
    return within(min, max, "whole number");
}

void note_idle(const lab::Contender& contender, std::span<const lab::SettingChange> changes) {
    for (const lab::SettingChange& change : changes) {
        if (change.engine != contender.engine) continue;
        const std::string when = contender.settings.idle(change.name);
        if (!when.empty()) say(contender.name + ": " + change.name + " has no effect here, " + when);
    }
}

void note_idle(std::span<const lab::ContenderRequest> requests, const Scene& scene,
               std::span<const lab::SettingChange> changes) {
    for (const lab::ContenderRequest& request : requests) {
        std::vector<lab::SettingChange> all(changes.begin(), changes.end());
        for (const auto& [name, value] : request.set) all.push_back({request.engine, name, value});
        note_idle(lab::contender_for(request, scene, lab::default_step, changes), all);
    }
}

Settings settings_with(const std::vector<std::string>& texts, const Engine& engine, const Scene& scene) {
    const Engine* const used[] = {&engine};
    const auto changes = lab::parse_changes(texts, used);
    Settings settings = lab::settings_for(engine, scene, changes);
    note_idle({&engine, settings, std::string(engine.name)}, changes);
    return settings;
}

void restore_from(const std::string& file, lab::Session& session) {
    if (file.empty()) return;
    const State state = load_state(file, session.scene());
    try {
        session.restore(state);
    } catch (const InputError& error) {  // that the engine cannot hold
        throw InputError(file + ": " + error.what());
    }
}

CLI::Option* add_contenders(CLI::App& command, std::vector<std::string>& contenders) {
    return command
        .add_option("--contender", contenders,
                    "An engine with a name, a step and settings of its own; given once for each")
        ->allow_extra_args(false)
        ->type_name("NAME=E[,dt=H][,K=V]...");
}

void add_libraries(CLI::App& command, std::vector<std::string>& libraries) {
    command
        .add_option("--engine", libraries,
                    "A library that takes part too (see docs/plugins.md); given once for each")
        ->allow_extra_args(false)
        ->type_name("FILE.so");
}

void RunOptions::add_to(CLI::App& command, const std::string& setting_form) {
    command.add_option("scene", scene, "A name (see `flipside scenes`) or the path of a scene file")
        ->required()
        ->type_name("SCENE");
    command.add_option("--dt", dt, "Step, s, as 0.01 or 1/60 (default: what the scene recommends, or 1/60)")
        ->type_name("H");
    command.add_option("--set", settings, "A setting (see `flipside engines`); may be given several times")
        ->allow_extra_args(false)
        ->type_name(setting_form);
    command
        .add_option("--script", script,
                    "Controls to apply (default: SCENE.script.json beside the scene, if there is one; "
                    "\"none\" for none)")
        ->type_name("FILE");
    command.add_option("--balls", balls, "Number of balls in a scene that generates a field of them")
        ->check(whole_number_from(1, most_things))
        ->type_name("N");
}

void RunOptions::add_seconds(CLI::App& command) {
    // What is shorter than a billionth of the longest step makes no step (timeline.hpp).
    constexpr double shortest = 1e-8;
    const auto is_a_time = [](const std::string& text) -> std::string {
        const double value = number_of<double>(text).value_or(0);
        if (value == 0 || value >= shortest) return "";
        return "'" + text + "' is not allowed; it takes 0, or a number from 1e-08";
    };
    command.add_option("--seconds", seconds, "How long, s (default 10)")
        ->check(number_from(0, 1e7))
        ->check(is_a_time)
        ->type_name("T");
}

std::shared_ptr<const Scene> RunOptions::load() const {
    const auto file = lab::scene_file(scene);
    auto loaded = std::make_shared<const Scene>(balls > 0 ? load_scene(file, balls) : load_scene(file));
    lab::require_known_engines(*loaded);
    return loaded;
}

double RunOptions::step(const Scene& loaded) const {
    return dt.empty() ? lab::step_for(loaded) : lab::parse_step(dt);
}

std::optional<std::filesystem::path> RunOptions::script_path() const {
    if (script == "none") return std::nullopt;
    if (!script.empty()) return script;
    return lab::script_beside(lab::scene_file(scene));
}

std::vector<NamedFile> RunOptions::inputs() const {
    return {{"the scene", lab::scene_file(scene)}, {"the script", script_path().value_or("")}};
}

Script RunOptions::load_script(const Scene& loaded) const {
    const auto path = script_path();
    if (!path) return {};
    Script controls = flipside::load_script(*path, loaded);
    if (script.empty()) say("controls from " + path->string() + " (--script none: none)");
    return controls;
}

}  // namespace flipside::app

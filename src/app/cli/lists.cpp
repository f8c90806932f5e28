#include "app/cli/commands.hpp"
#include "app/cli/output.hpp"
#include "lab/contenders/engines.hpp"
#include "lab/contenders/recommended.hpp"
#include "lab/files/assets.hpp"
#include "lab/files/text_stream.hpp"
#include "lab/scenes/scene_notes.hpp"
#include "world/input_error.hpp"
#include "world/printable.hpp"
#include "world/scene_file.hpp"

namespace flipside::app {

namespace {

int list_scenes() {
    for (const std::string& name : lab::scene_names())
        print("%s\n    %s\n", printable(name).c_str(),
              printable(load_scene(lab::scene_file(name)).about).c_str());
    return 0;
}

std::string range_of(const SettingSpec& spec) {
    lab::TextStream text;
    switch (spec.type) {
        case SettingType::toggle:
            return "on, off";
        case SettingType::choice:
            for (const std::string_view choice : spec.choices)
                text << (choice == spec.choices.front() ? "" : ", ") << choice;
            return text.str();
        case SettingType::integer:
        case SettingType::real:
            text << spec.min << " to " << spec.max << (spec.unit.empty() ? "" : " ") << spec.unit;
    }
    return text.str();
}

/// With what it has an effect.
std::string needs_of(const SettingSpec& spec) {
    std::string text;
    for (const std::string_view value : spec.acts_with.values)
        text += (text.empty() ? ", only with " + std::string(spec.acts_with.setting) + ' ' : " or ") +
                std::string(value);
    return text;
}

/// All that are built in, or these libraries.
int list_engines(const std::vector<std::string>& libraries) {
    std::vector<const Engine*> listed(lab::engines().begin(), lab::engines().end());
    if (!libraries.empty()) listed.clear();
    for (const std::string& library : libraries) listed.push_back(&lab::engine_named(library));
    for (const Engine* engine : listed) {
        lab::TextStream text;
        text << engine->name << ": " << (engine->library.empty() ? "" : std::string(engine->library) + ": ")
             << engine->about << '\n';
        const Settings defaults(engine->settings);
        for (const SettingSpec& spec : engine->settings)
            text << "  " << spec.name << " = " << defaults.text(spec.name) << "  (" << range_of(spec) << ')'
                 << needs_of(spec) << "\n      " << spec.about << '\n';
        print_text(text.str());
    }
    return 0;
}

/// "box2d cannot run it: WHY" for each engine that cannot. Throws InputError where none can.
std::vector<std::string> notes_on_engines(const std::shared_ptr<const Scene>& scene) {
    std::vector<std::string> notes;
    for (const Engine* engine : lab::engines()) {
        const Settings settings = lab::settings_for(*engine, *scene);
        try {
            engine->make(scene, settings);
        } catch (const InputError& error) {
            notes.push_back(std::string(engine->name) + " cannot run it: " + error.what());
            if (notes.size() == lab::engines().size()) throw;
        }
    }
    return notes;
}

/// The file and what the scene recommends; then what not every engine can do, and what looks unmeant.
int check(const std::string& name_or_path) {
    const auto file = lab::scene_file(name_or_path);
    const auto scene = std::make_shared<const Scene>(load_scene(file));
    lab::require_known_engines(*scene);
    static_cast<void>(lab::step_for(*scene));
    std::vector<std::string> notes = notes_on_engines(scene);
    for (std::string& note : lab::notes_on(*scene)) notes.push_back(std::move(note));
    print("%s: good: scene '%s', parts %zu, balls %zu\n", printable(file.string()).c_str(),
          printable(scene->name).c_str(), scene->parts.size(), scene->balls.size());
    for (const std::string& note : notes) print("note: %s\n", printable(note).c_str());
    return 0;
}

}  // namespace

void add_scenes(CLI::App& program, Action& chosen) {
    program.add_subcommand("scenes", "List the scenes")->callback([&chosen] { chosen = list_scenes; });
}

void add_engines(CLI::App& program, Action& chosen) {
    auto libraries = std::make_shared<std::vector<std::string>>();
    CLI::App& command = *program.add_subcommand("engines", "List the engines with all their settings");
    command.add_option("libraries", *libraries, "Only these: names, or libraries (see docs/plugins.md)")
        ->type_name("FILE.so");
    command.callback([libraries, &chosen] { chosen = [libraries] { return list_engines(*libraries); }; });
}

void add_check(CLI::App& program, Action& chosen) {
    auto file = std::make_shared<std::string>();
    CLI::App& command = *program.add_subcommand("check", "Say whether a scene file is good, and if not why");
    command.add_option("file", *file, "The scene file, or a scene's name")->required()->type_name("FILE");
    command.callback([file, &chosen] { chosen = [file] { return check(*file); }; });
}

}  // namespace flipside::app

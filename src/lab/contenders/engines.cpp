#include "lab/contenders/engines.hpp"

#include <algorithm>
#include <filesystem>
#include <memory>

#include "box2d/engine.hpp"
#include "custom/engine.hpp"
#include "plugin/engine.hpp"
#include "reference/engine.hpp"
#include "world/input_error.hpp"

namespace flipside::lab {

namespace {

std::string known(std::span<const Engine* const> some) {
    std::string text;
    for (const Engine* engine : some) text += (text.empty() ? "" : ", ") + std::string(engine->name);
    return text;
}

/// "" where the text names no engine.
std::string_view engine_part(std::string_view name) {
    const std::size_t dot = name.find('.');
    return dot == std::string_view::npos ? "" : name.substr(0, dot);
}

SettingChange parse_change(const std::string& text, std::span<const Engine* const> used) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos)
        throw InputError("setting '" + text + "' has no value; write NAME=VALUE or ENGINE.NAME=VALUE");
    const std::string name = text.substr(0, equals), value = text.substr(equals + 1);

    const std::string_view prefix = engine_part(name);
    if (prefix.empty() && used.size() != 1)
        throw InputError("setting '" + text + "' does not say of which engine; write ENGINE." + text +
                         " with one of " + known(used));
    const Engine& engine = prefix.empty() ? *used.front() : engine_named(prefix);
    if (std::ranges::find(used, &engine) == used.end())
        throw InputError("setting '" + text + "' is of an engine that is not used here; used are " +
                         known(used));

    SettingChange change{&engine, prefix.empty() ? name : name.substr(prefix.size() + 1), value};
    Settings(engine.settings).set(change.name, change.value);
    return change;
}

/// Those that are built in, and after them those that were loaded.
struct Registry {
    std::vector<const Engine*> all{&custom::engine(), &box2d::engine(), &reference::engine()};
    std::vector<std::unique_ptr<const plugin::Plugin>> plugins;
};

Registry& registry() {
    static Registry only;
    return only;
}

/// The engine of a library, which is loaded once.
const Engine& loaded(std::string_view file) {
    Registry& there = registry();
    std::error_code none;
    const std::filesystem::path whole = std::filesystem::canonical(file, none);
    const auto at =
        std::ranges::find_if(there.plugins, [&](const auto& one) { return one->file == whole.string(); });
    if (at != there.plugins.end()) return (*at)->engine;
    std::vector<std::string_view> taken;
    for (const Engine* engine : there.all) taken.push_back(engine->name);
    there.plugins.push_back(plugin::load(file, taken));
    there.all.push_back(&there.plugins.back()->engine);
    return *there.all.back();
}

}  // namespace

std::span<const Engine* const> engines() {
    return registry().all;
}

std::vector<const Engine*> engines_beside(std::span<const std::string_view> names) {
    std::vector<const Engine*> others;
    for (const Engine* engine : engines())
        if (std::ranges::find(names, engine->name) == names.end()) others.push_back(engine);
    return others;
}

const Engine& engine_named(std::string_view name) {
    if (name.find('/') != std::string_view::npos) return loaded(name);
    const auto at = std::ranges::find(engines(), name, &Engine::name);
    if (at == engines().end())
        throw InputError("unknown engine '" + std::string(name) + "'; known are " + known(engines()));
    return **at;
}

std::string libraries() {
    std::string text;
    for (const Engine* engine : engines()) {
        if (engine->library.empty()) continue;
        text +=
            (text.empty() ? "" : ", ") + std::string(engine->name) + " is " + std::string(engine->library);
    }
    return text;
}

std::vector<SettingChange> parse_changes(std::span<const std::string> texts,
                                         std::span<const Engine* const> used) {
    std::vector<SettingChange> changes;
    for (const std::string& text : texts) {
        SettingChange change = parse_change(text, used);
        const auto same = [&](const SettingChange& other) {
            return other.engine == change.engine && other.name == change.name;
        };
        if (std::ranges::any_of(changes, same))
            throw InputError("setting '" + change.name + "' of " + std::string(change.engine->name) +
                             " is given twice; allowed is once");
        changes.push_back(std::move(change));
    }
    return changes;
}

}  // namespace flipside::lab

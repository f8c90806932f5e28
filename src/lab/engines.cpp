#include "lab/engines.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "box2d/engine.hpp"
#include "custom/engine.hpp"
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

}  // namespace

std::span<const Engine* const> engines() {
    static const Engine* const all[] = {&custom::engine(), &box2d::engine(), &reference::engine()};
    return all;
}

const Engine& engine_named(std::string_view name) {
    const auto at = std::ranges::find(engines(), name, &Engine::name);
    if (at == engines().end())
        throw InputError("unknown engine '" + std::string(name) + "'; known are " + known(engines()));
    return **at;
}

std::vector<SettingChange> parse_changes(std::span<const std::string> texts,
                                         std::span<const Engine* const> used) {
    std::vector<SettingChange> changes;
    for (const std::string& text : texts) changes.push_back(parse_change(text, used));
    return changes;
}

Settings settings_for(const Engine& engine, const Scene& scene, std::span<const SettingChange> changes) {
    Settings settings(engine.settings);
    if (const auto at = scene.recommend.find(std::string(engine.name)); at != scene.recommend.end()) {
        try {
            for (const auto& [name, value] : at->second) settings.set(name, value);
        } catch (const InputError& error) {
            throw InputError("scene '" + scene.name + "' recommends for " + at->first + ": " + error.what());
        }
    }
    for (const SettingChange& change : changes)
        if (change.engine == &engine) settings.set(change.name, change.value);
    return settings;
}

double parse_step(std::string_view text) {
    const auto number = [&](std::string_view part) {
        double value = 0;
        const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), value);
        const bool good = error == std::errc{} && end == part.data() + part.size();
        return good ? value : std::nan("");
    };
    const std::size_t slash = text.find('/');
    const double step = slash == std::string_view::npos
                            ? number(text)
                            : number(text.substr(0, slash)) / number(text.substr(slash + 1));
    if (!(step >= shortest_step && step <= longest_step))
        throw InputError("step '" + std::string(text) +
                         "' is not allowed; it takes seconds from 1e-6 to 1, as 0.01 or 1/60");
    return step;
}

double step_for(const Scene& scene) {
    const auto run = scene.recommend.find("run");
    if (run == scene.recommend.end()) return default_step;
    const auto dt = run->second.find("dt");
    if (dt == run->second.end()) return default_step;
    try {
        return parse_step(dt->second);
    } catch (const InputError& error) {
        throw InputError("scene '" + scene.name + "' recommends for run: " + error.what());
    }
}

}  // namespace flipside::lab

#include "lab/session/run_settings.hpp"

#include <charconv>
#include <cmath>

#include "world/input_error.hpp"
#include "world/json_file.hpp"

namespace flipside::lab {

namespace {

constexpr const char* of_the_run = "run";

[[noreturn]] void fail_recommended(const Scene& scene, std::initializer_list<std::string_view> keys,
                                   const std::string& problem) {
    std::string where = scene.place + "/recommend";
    for (const std::string_view key : keys) where += '/' + pointer_token(key);
    throw InputError(where + ": " + problem);
}

}  // namespace

Settings settings_for(const Engine& engine, const Scene& scene, std::span<const SettingChange> changes) {
    Settings settings(engine.settings);
    if (const auto at = scene.recommend.find(std::string(engine.name)); at != scene.recommend.end()) {
        for (const auto& [name, value] : at->second) {
            try {
                settings.set(name, value);
            } catch (const InputError& error) {
                fail_recommended(scene, {at->first, name}, error.what());
            }
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
    const auto run = scene.recommend.find(of_the_run);
    if (run == scene.recommend.end()) return default_step;
    const auto dt = run->second.find("dt");
    if (dt == run->second.end()) return default_step;
    try {
        return parse_step(dt->second);
    } catch (const InputError& error) {
        fail_recommended(scene, {of_the_run, dt->first}, error.what());
    }
}

}  // namespace flipside::lab

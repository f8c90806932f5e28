#include "plugin/engine.hpp"

#include <algorithm>
#include <system_error>

#include "plugin/process.hpp"
#include "plugin/world.hpp"
#include "world/input_error.hpp"

namespace flipside::plugin {

namespace {

Description describe(const std::filesystem::path& file) {
    const std::string shown = file.string();
    try {
        Process process(file);
        Bytes answer;
        const Answer kind = process.receive(answer);
        Reader in(answer);
        if (kind == Answer::done) return Description::read(in);
        throw InputError(shown, "", in.text());
    } catch (const Ended& ended) {
        throw InputError(shown, "",
                         std::string("the process of this engine ") + ended.what() + " while it was loaded");
    } catch (const Malformed&) {
        throw InputError(shown, "", "describes itself in nonsense");
    }
}

/// A word that a figure, a file and a setting may be called by.
std::string plain_word(std::string_view name) {
    constexpr std::size_t longest = 24;
    std::string word;
    for (const char c : name.substr(0, longest)) {
        const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
        if (plain)
            word += c;
        else if (!word.empty() && word.back() != '-')
            word += '-';
    }
    while (!word.empty() && word.back() == '-') word.pop_back();
    return word;
}

std::string name_for(std::string_view own, const std::filesystem::path& file,
                     std::span<const std::string_view> taken) {
    std::string first = plain_word(own);
    if (first.empty()) first = plain_word(file.stem().string());
    if (first.empty()) first = "engine";
    std::string name = first;
    for (int i = 2; std::ranges::find(taken, name) != taken.end(); ++i)
        name = first + "-" + std::to_string(i);
    return name;
}

}  // namespace

std::unique_ptr<const Plugin> load(const std::filesystem::path& file,
                                   std::span<const std::string_view> taken) {
    std::error_code why;
    const std::filesystem::path whole = std::filesystem::canonical(file, why);
    if (why) throw InputError(file.string(), "", "cannot be read (" + why.message() + ")");
    if (!std::filesystem::is_regular_file(whole, why))
        throw InputError(file.string(), "", "is no regular file; allowed is a shared library");
    auto plugin = std::make_unique<Plugin>();
    plugin->file = whole.string();
    plugin->description = describe(whole);
    const Description& own = plugin->description;
    plugin->name = name_for(own.name, whole, taken);
    for (const SettingDescription& setting : own.settings)
        plugin->choices.emplace_back(setting.choices.begin(), setting.choices.end());
    for (std::size_t i = 0; i < own.settings.size(); ++i) {
        const SettingDescription& setting = own.settings[i];
        plugin->settings.push_back({.name = setting.name,
                                    .type = setting.type,
                                    .unit = setting.unit,
                                    .initial = setting.initial,
                                    .min = setting.min,
                                    .max = setting.max,
                                    .choices = plugin->choices[i],
                                    .about = setting.about});
    }
    plugin->engine = {
        .name = plugin->name,
        .about = own.about,
        .settings = plugin->settings,
        .make =
            [self = plugin.get()](std::shared_ptr<const Scene> scene, const Settings& settings) {
                return std::make_unique<PluginWorld>(std::move(scene), *self, settings);
            },
        .library = own.library,
        .file = plugin->file};
    return plugin;
}

}  // namespace flipside::plugin

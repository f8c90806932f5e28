#include "plugin/description.hpp"

#include <algorithm>
#include <stdexcept>

#include "flipside/engine.h"
#include "world/json_file.hpp"
#include "world/printable.hpp"

namespace flipside::plugin {

namespace {

/// One line of at most so many bytes; null is "".
std::string line(const char* text, std::size_t most = 400) {
    return printable(std::string(text ? std::string_view(text).substr(0, most) : ""));
}

bool is_word(std::string_view name) {
    const auto fits = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
    };
    return !name.empty() && name.size() <= 60 && std::ranges::all_of(name, fits);
}

SettingDescription describe(const flipside_setting& setting) {
    if (setting.kind > FLIPSIDE_CHOICE)
        throw std::invalid_argument("a setting is of kind " + std::to_string(setting.kind) +
                                    ", which there is not");
    SettingDescription out{.name = setting.name ? setting.name : "",
                           .unit = line(setting.unit),
                           .about = line(setting.about),
                           .type = static_cast<SettingType>(setting.kind),
                           .initial = setting.initial,
                           .min = setting.min,
                           .max = setting.max,
                           .choices = {}};
    if (!is_word(out.name))
        throw std::invalid_argument("a setting is called " + in_quotes(out.name) +
                                    "; names are letters, digits and _");
    if (setting.kind == FLIPSIDE_CHOICE)
        for (std::uint32_t i = 0; i < setting.choice_count && setting.choices; ++i)
            out.choices.push_back(line(setting.choices[i], 60));
    const std::vector<std::string_view> names(out.choices.begin(), out.choices.end());
    const SettingSpec spec{.name = out.name,
                           .type = out.type,
                           .initial = out.initial,
                           .min = out.min,
                           .max = out.max,
                           .choices = names,
                           .about = out.about};
    try {
        Settings({&spec, 1}).set(out.name, out.initial);
    } catch (const std::runtime_error& error) {
        throw std::invalid_argument(std::string("its default is outside its range: ") + error.what());
    }
    return out;
}

}  // namespace

Description describe(const flipside_engine& engine) {
    constexpr std::uint32_t most_settings = 1000;
    Description out{.name = line(engine.name),
                    .about = line(engine.about),
                    .library = line(engine.library),
                    .features = engine.features,
                    .offers = {.destroy = engine.destroy != nullptr,
                               .events = engine.events != nullptr,
                               .contacts = engine.contacts != nullptr,
                               .control = engine.control != nullptr,
                               .save = engine.save != nullptr && engine.restore != nullptr},
                    .settings = {}};
    if (engine.setting_count > most_settings || (engine.setting_count > 0 && !engine.settings))
        throw std::invalid_argument("has " + std::to_string(engine.setting_count) + " settings");
    if ((out.features & (FLIPSIDE_SENSORS | FLIPSIDE_GATES)) != 0 && !out.offers.events)
        throw std::invalid_argument("declares sensors or gates, but has no events to tell of them");
    for (std::uint32_t i = 0; i < engine.setting_count; ++i) {
        out.settings.push_back(describe(engine.settings[i]));
        const auto same = [&](const SettingDescription& one) { return one.name == out.settings.back().name; };
        if (std::ranges::count_if(out.settings, same) > 1)
            throw std::invalid_argument("setting " + out.settings.back().name + " is there twice");
    }
    return out;
}

void Description::write(Writer& out) const {
    out.text(name);
    out.text(about);
    out.text(library);
    out.value(features);
    out.value(offers);
    out.value(static_cast<std::uint64_t>(settings.size()));
    for (const SettingDescription& setting : settings) {
        for (const std::string* text : {&setting.name, &setting.unit, &setting.about}) out.text(*text);
        out.value(setting.type);
        for (const double number : {setting.initial, setting.min, setting.max}) out.value(number);
        out.value(static_cast<std::uint64_t>(setting.choices.size()));
        for (const std::string& choice : setting.choices) out.text(choice);
    }
}

Description Description::read(Reader& in) {
    Description out;
    out.name = in.text();
    out.about = in.text();
    out.library = in.text();
    out.features = in.value<std::uint64_t>();
    out.offers = in.value<Offers>();
    for (auto n = in.value<std::uint64_t>(); n > 0; --n) {
        SettingDescription setting;
        for (std::string* text : {&setting.name, &setting.unit, &setting.about}) *text = in.text();
        setting.type = in.value<SettingType>();
        for (double* number : {&setting.initial, &setting.min, &setting.max}) *number = in.value<double>();
        for (auto choices = in.value<std::uint64_t>(); choices > 0; --choices)
            setting.choices.push_back(in.text());
        out.settings.push_back(std::move(setting));
    }
    in.finish();
    return out;
}

}  // namespace flipside::plugin

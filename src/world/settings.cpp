#include "world/settings.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "world/input_error.hpp"
#include "world/number_text.hpp"

namespace flipside {

namespace {

std::string list(auto&& names, const char* between = ", ") {
    std::string text;
    for (const auto& name : names) {
        if (!text.empty()) text += between;
        text += name;
    }
    return text;
}

/// What a setting accepts, for error messages.
std::string allowed(const SettingSpec& spec) {
    switch (spec.type) {
        case SettingType::toggle:
            return "on or off";
        case SettingType::choice:
            return "one of " + list(spec.choices);
        case SettingType::integer:
        case SettingType::real:
            break;
    }
    const std::string kind = spec.type == SettingType::integer ? "a whole number" : "a number";
    const std::string unit = spec.unit.empty() ? "" : " " + std::string(spec.unit);
    return kind + " from " + number_text(spec.min) + " to " + number_text(spec.max) + unit;
}

[[noreturn]] void refuse(const SettingSpec& spec, std::string_view value) {
    const auto retired = std::ranges::find(spec.retired, value, &RetiredChoice::name);
    if (retired != spec.retired.end())
        throw InputError("setting " + std::string(spec.name) + ": '" + std::string(value) +
                         "' is no longer there; " + std::string(retired->advice));
    throw InputError("setting " + std::string(spec.name) + ": '" + std::string(value) +
                     "' is not allowed; it takes " + allowed(spec));
}

double parse(const SettingSpec& spec, std::string_view text) {
    if (spec.type == SettingType::toggle) {
        if (text == "on" || text == "true" || text == "1") return 1;
        if (text == "off" || text == "false" || text == "0") return 0;
        refuse(spec, text);
    }
    if (spec.type == SettingType::choice) {
        const auto at = std::ranges::find(spec.choices, text);
        if (at == spec.choices.end()) refuse(spec, text);
        return static_cast<double>(at - spec.choices.begin());
    }
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size()) refuse(spec, text);
    return value;
}

bool valid(const SettingSpec& spec, double value) {
    if (!std::isfinite(value)) return false;
    const bool whole = value == std::floor(value);
    switch (spec.type) {
        case SettingType::toggle:
            return value == 0 || value == 1;
        case SettingType::choice:
            return whole && value >= 0 && value < static_cast<double>(spec.choices.size());
        case SettingType::integer:
            return whole && value >= spec.min && value <= spec.max;
        case SettingType::real:
            return value >= spec.min && value <= spec.max;
    }
    return false;
}

}  // namespace

Settings::Settings(std::span<const SettingSpec> specs) : specs_(specs) {
    values_.reserve(specs.size());
    for (const SettingSpec& spec : specs) values_.push_back(spec.initial);
}

std::size_t Settings::index(std::string_view name) const {
    const auto at = std::ranges::find(specs_, name, &SettingSpec::name);
    if (at == specs_.end()) {
        std::vector<std::string_view> names;
        for (const SettingSpec& spec : specs_) names.push_back(spec.name);
        throw InputError("unknown setting '" + std::string(name) + "'; known are " + list(names));
    }
    return static_cast<std::size_t>(at - specs_.begin());
}

void Settings::set(std::string_view name, std::string_view value) {
    const std::size_t i = index(name);
    const double parsed = parse(specs_[i], value);
    if (!valid(specs_[i], parsed)) refuse(specs_[i], value);
    values_[i] = parsed;
}

void Settings::set(std::string_view name, double value) {
    const std::size_t i = index(name);
    if (!valid(specs_[i], value)) refuse(specs_[i], number_text(value));
    values_[i] = value;
}

double Settings::real(std::string_view name) const {
    return values_[index(name)];
}
int Settings::integer(std::string_view name) const {
    return static_cast<int>(values_[index(name)]);
}
bool Settings::toggle(std::string_view name) const {
    return values_[index(name)] != 0;
}

std::string_view Settings::choice(std::string_view name) const {
    const std::size_t i = index(name);
    return specs_[i].choices[static_cast<std::size_t>(values_[i])];
}

std::string Settings::text(std::string_view name) const {
    const std::size_t i = index(name);
    switch (specs_[i].type) {
        case SettingType::toggle:
            return values_[i] != 0 ? "on" : "off";
        case SettingType::choice:
            return std::string(choice(name));
        case SettingType::integer:
        case SettingType::real:
            break;
    }
    return number_text(values_[i]);
}

std::string Settings::idle(std::string_view name) const {
    const Condition& condition = specs_[index(name)].acts_with;
    if (condition.setting.empty()) return "";
    if (std::ranges::find(condition.values, text(condition.setting)) != condition.values.end())
        return idle(condition.setting);
    return "only with " + std::string(condition.setting) + ' ' + list(condition.values, " or ");
}

}  // namespace flipside

#include "lab/tune/search_space.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace flipside::lab::tune {

namespace {

/// Three digits: what is found is to be typed.
std::string short_text(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3g", value);
    return text;
}

std::set<double> integers(const SettingSpec& spec) {
    std::set<double> values{spec.initial};
    const double one = std::max(1.0, spec.initial);
    for (int k = -4; k <= 4; ++k) values.insert(std::round(std::ldexp(one, k)));
    return values;
}

std::set<double> reals(const SettingSpec& spec) {
    std::set<double> values{spec.initial};
    const bool from_top = spec.initial == 0;
    const double one = from_top ? spec.max : spec.initial;
    for (int k = from_top ? -12 : -4; k <= (from_top ? 0 : 4); ++k) {
        double power = one;
        for (int i = 0; i < std::abs(k); ++i)
            power = k < 0 ? power / std::sqrt(10.0) : power * std::sqrt(10.0);
        values.insert(power);
    }
    return values;
}

}  // namespace

std::vector<std::string> candidates_of(const SettingSpec& spec) {
    std::vector<std::string> texts;
    switch (spec.type) {
        case SettingType::toggle:
            return {"on", "off"};
        case SettingType::choice:
            texts.assign(spec.choices.begin(), spec.choices.end());
            break;
        case SettingType::integer:
        case SettingType::real:
            for (const double value : spec.type == SettingType::integer ? integers(spec) : reals(spec))
                if (value >= spec.min && value <= spec.max) texts.push_back(short_text(value));
            break;
    }
    return texts;
}

}  // namespace flipside::lab::tune

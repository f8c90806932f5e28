#pragma once
/// What a library says of itself, taken out of its process.

#include <cstdint>
#include <string>
#include <vector>

#include "plugin/bytes.hpp"
#include "world/settings.hpp"

struct flipside_engine;

namespace flipside::plugin {

struct SettingDescription {
    std::string name, unit, about;
    SettingType type = SettingType::real;
    double initial = 0, min = 0, max = 0;
    std::vector<std::string> choices;

    friend bool operator==(const SettingDescription&, const SettingDescription&) = default;
};

/// What of the optional functions there is.
struct Offers {
    bool destroy = false, events = false, contacts = false, control = false, save = false;

    friend bool operator==(const Offers&, const Offers&) = default;
};

struct Description {
    std::string name, about, library;
    std::uint64_t features = 0;
    Offers offers;
    std::vector<SettingDescription> settings;

    void write(Writer& out) const;
    [[nodiscard]] static Description read(Reader& in);
    friend bool operator==(const Description&, const Description&) = default;
};

/// Of an engine whose size and version are right. Throws std::invalid_argument with what is wrong: a setting
/// without a name, a default outside its range.
[[nodiscard]] Description describe(const flipside_engine& engine);

}  // namespace flipside::plugin

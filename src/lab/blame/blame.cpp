#include "lab/blame/blame.hpp"

#include <iterator>
#include <numbers>

#include "lab/files/csv.hpp"
#include "world/printable.hpp"
#include "world/trace.hpp"

namespace flipside::lab {

namespace {

/// The stage a fault comes from, and its amount in words.
struct Description {
    std::string_view stage, before, unit;
    double scale = 1;  ///< of the amount, to the unit
};
constexpr double degrees = 180 / std::numbers::pi;
/// By Fault.
constexpr Description descriptions[] = {
    {"integration", "drift in flight of ", " m"},
    {"narrow phase", "contact missed at ", " m/s"},
    {"broad phase", "contact missed, its pair not found, at ", " m/s"},
    {"continuous collision", "tunnelled at ", " m/s"},
    {"gate", "let through at ", " m/s"},
    {"narrow phase", "contact invented at ", " m/s"},
    {"time of impact", "contact late by ", " s"},
    {"time of impact", "contact early by ", " s"},
    {"narrow phase", "normal off by ", " degrees", degrees},
    {"response", "impulse off by ", " m/s"},
    {"response", "friction off by ", " m/s"},
    {"resting contact", "resting contact off by ", " m"},
    {"motion of parts", "part mistimed by ", " rad"},
    {"none", "the run stopped", ""},
    {"unknown", "unknown", ""},
};
static_assert(std::size(descriptions) == std::size(fault_names));

const Description& description_of(Fault fault) {
    return descriptions[static_cast<int>(fault)];
}

}  // namespace

std::string_view stage_of(Fault fault) {
    return description_of(fault).stage;
}

std::string in_words(Fault fault, double amount) {
    const Description& is = description_of(fault);
    if (is.unit.empty()) return std::string(is.before);
    return std::string(is.before) + brief(amount * is.scale) + std::string(is.unit);
}

std::string in_words(const Blame& blame, const Scene& scene) {
    std::string words = in_words(blame.fault, blame.amount);
    if (blame.other) {
        Event met;
        met.other = *blame.other;
        words += " at " + blame.kind;
        words += blame.other->is_ball ? " " + std::to_string(blame.other->index)
                                      : " '" + printable(name_of_other(met, scene)) + "'";
    }
    words += ", ball " + std::to_string(blame.ball) + ", " + brief(blame.time) + " s";
    return words + " (" + std::string(stage_of(blame.fault)) + ")";
}

}  // namespace flipside::lab

#include "world/trace_units.hpp"

#include <algorithm>
#include <iterator>
#include <variant>

namespace flipside {

namespace {

struct FieldUnit {
    std::string_view field, unit;
};

// What is said of the other body has the same name behind "other_".
constexpr FieldUnit units[] = {
    {"a", "m"},
    {"acceleration", "m/s²"},
    {"angle", "rad"},
    {"angle_before", "rad"},
    {"approach", "m/s"},
    {"b", "m"},
    {"box", "m"},
    {"center", "m"},
    {"closing", "m/s"},
    {"core", "m"},
    {"correction", "m"},
    {"damping", "1/s"},
    {"depth", "m"},
    {"drag", "1/s"},
    {"foot", "m"},
    {"from", "rad"},
    {"gap", "m"},
    {"gravity", "m/s²"},
    {"h", "s"},
    {"heights", "m"},
    {"impulse", "N·s"},
    {"isolated_within", "s"},
    {"kick", "m/s"},
    {"middle", "m"},
    {"next_time", "s"},
    {"outline", "m"},
    {"pivot", "m"},
    {"point", "m"},
    {"pose_angle", "rad"},
    {"position", "m"},
    {"position_before", "m"},
    {"push_out", "m"},
    {"radius", "m"},
    {"residual", "m/s"},
    {"seconds", "s"},
    {"separation", "m"},
    {"shadow_of_ball", "m"},
    {"shadow_of_part", "m"},
    {"since", "s"},
    {"speed", "m/s"},
    {"spin", "rad/s"},
    {"spin_before", "rad/s"},
    {"surface_velocity", "m/s"},
    {"swept", "m"},
    {"tangential_impulse", "N·s"},
    {"tight_box", "m"},
    {"time", "s"},
    {"time_of_impact", "s"},
    {"to", "rad"},
    {"uncertainty", "m"},
    {"velocity", "m/s"},
    {"velocity_before", "m/s"},
};

}  // namespace

std::string_view unit_of(std::string_view field, const TraceValue& value) {
    const bool measured = std::holds_alternative<double>(value) || std::holds_alternative<Vec2>(value) ||
                          std::holds_alternative<Box>(value) ||
                          std::holds_alternative<std::vector<double>>(value);
    if (!measured) return "";
    constexpr std::string_view of_other = "other_";
    if (field.starts_with(of_other)) field.remove_prefix(of_other.size());
    const auto* at = std::ranges::find(units, field, &FieldUnit::field);
    return at == std::end(units) ? std::string_view() : at->unit;
}

std::string with_its_unit(std::string_view field, const TraceValue& value) {
    const std::string_view unit = unit_of(field, value);
    return in_brief(value) + (unit.empty() ? "" : " " + std::string(unit));
}

}  // namespace flipside

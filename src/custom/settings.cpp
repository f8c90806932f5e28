#include "custom/settings.hpp"

#include <algorithm>
#include <array>

#include "custom/broad_phase/registry.hpp"

namespace flipside::custom {

namespace {

constexpr std::string_view solvers[] = {"continuous", "simple"};
constexpr RetiredChoice retired_solvers[] = {
    {"discrete", "take continuous, which is exact and faster, or simple, which steps as it did"},
    {"auto", "take continuous, which it chose for few balls and which now serves any number"}};
/// The names of all broad phases, and "auto".
constexpr auto broad_phase_names = [] {
    std::array<std::string_view, std::size(broad_phases) + 1> names{};
    std::ranges::transform(broad_phases, names.begin(), &BroadPhaseKind::name);
    names.back() = "auto";
    return names;
}();

constexpr std::string_view continuous[] = {"continuous"}, simple[] = {"simple"}, on[] = {"on"},
                           quadtree[] = {"quadtree"}, adaptive[] = {"adaptive", "auto"},
                           grid[] = {"grid", "auto"};

/// A whole number from 1 to `most`.
constexpr SettingSpec integer(std::string_view name, double initial, double most, Condition acts_with,
                              std::string_view about, bool everyday = false) {
    return {.name = name,
            .type = SettingType::integer,
            .initial = initial,
            .min = 1,
            .max = most,
            .about = about,
            .acts_with = acts_with,
            .everyday = everyday};
}

constexpr SettingSpec specs[] = {
    {.name = "solver",
     .type = SettingType::choice,
     .choices = solvers,
     .retired = retired_solvers,
     .about = "continuous: every impact at its exact time; simple: the loop of a toy, to be read; fast balls "
              "tunnel, heaps overlap",
     .everyday = true},
    integer(
        "max_impacts", 500'000, 1e9, {"solver", continuous},
        "events that the continuous solver handles in a quarter of a second before balls have to wait for "
        "the next tick (1/240 s or less); too few and a busy scene loses its exactness"),
    integer("motion_iterations", 4, 64, {"solver", simple},
            "flights per step; too few and what a ball does after a hit within a flight comes late", true),
    integer("collision_iterations", 6, 64, {"solver", simple},
            "rounds of response after each flight; too few and heaps stick as if rough", true),
    {.name = "broad_phase",
     .type = SettingType::choice,
     .initial = broad_phase_names.size() - 1,
     .choices = broad_phase_names,
     .about = "how candidate pairs are found; changes the cost, never the outcome; auto: brute force for "
              "very few shapes, an adaptive quadtree where balls differ much in size, else a grid",
     .acts_with = {"solver", simple},
     .everyday = true},
    integer("quadtree_levels", 4, 8, {"broad_phase", quadtree},
            "levels below the root; too few crowd the leaves, too many list a ball in many of them"),
    integer("adaptive_capacity", 8, 1000, {"broad_phase", adaptive},
            "shapes in a node before it is split; too few split for little, too many are tested in vain"),
    integer("adaptive_depth", 8, 24, {"broad_phase", adaptive},
            "how often the adaptive quadtree splits at most; too few crowd the leaves"),
    {.name = "grid_cell",
     .type = SettingType::real,
     .unit = "m",
     .initial = 0,
     .min = 0,
     .max = 1e6,
     .about = "width of a cell of the grid, 0: fitted to the balls; too small and balls are listed in many "
              "cells, too large and cells are crowded",
     .acts_with = {"broad_phase", grid}},
    {.name = "sleep",
     .type = SettingType::toggle,
     .initial = 1,
     .about = "balls at rest are neither moved nor solved for until something touches them",
     .acts_with = {"solver", continuous},
     .everyday = true},
    {.name = "sleep_speed",
     .type = SettingType::real,
     .unit = "m/s",
     .initial = 0.001,
     .min = 0,
     .max = 1,
     .about = "balls slower than this that nothing drives fall asleep; too large and they stop early",
     .acts_with = {"sleep", on}},
};

}  // namespace

std::span<const SettingSpec> setting_specs() {
    return specs;
}

SolverSettings::SolverSettings(const Settings& settings)
    : solver(settings.choice("solver")),
      motion_iterations(settings.integer("motion_iterations")),
      collision_iterations(settings.integer("collision_iterations")),
      sleep(settings.toggle("sleep")),
      sleep_speed(settings.real("sleep_speed")),
      max_impacts(static_cast<std::uint64_t>(settings.integer("max_impacts"))) {}

}  // namespace flipside::custom

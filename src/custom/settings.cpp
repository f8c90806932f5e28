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

constexpr SettingSpec specs[] = {
    {.name = "solver",
     .type = SettingType::choice,
     .choices = solvers,
     .retired = retired_solvers,
     .about = "continuous: every impact at its exact time; simple: the loop of a toy, to be read; fast balls "
              "tunnel, heaps overlap",
     .everyday = true},
    {.name = "max_impacts",
     .type = SettingType::integer,
     .initial = 500'000,
     .min = 1,
     .max = 1e9,
     .about = "events that the continuous solver handles in a quarter of a second before balls have to wait "
              "for the next tick (1/240 s or less); too few and a busy scene loses its exactness",
     .acts_with = {"solver", continuous}},
    {.name = "motion_iterations",
     .type = SettingType::integer,
     .initial = 4,
     .min = 1,
     .max = 64,
     .about = "flights per step; too few and what a ball does after a hit within a flight comes late",
     .acts_with = {"solver", simple},
     .everyday = true},
    {.name = "collision_iterations",
     .type = SettingType::integer,
     .initial = 6,
     .min = 1,
     .max = 64,
     .about = "rounds of response after each flight; too few and heaps stick as if rough",
     .acts_with = {"solver", simple},
     .everyday = true},
    {.name = "broad_phase",
     .type = SettingType::choice,
     .initial = broad_phase_names.size() - 1,
     .choices = broad_phase_names,
     .about = "how candidate pairs are found; changes the cost, never the outcome; auto: brute force for "
              "very few shapes, an adaptive quadtree where balls differ much in size, else a grid",
     .acts_with = {"solver", simple},
     .everyday = true},
    {.name = "quadtree_levels",
     .type = SettingType::integer,
     .initial = 4,
     .min = 1,
     .max = 8,
     .about = "levels below the root; too few crowd the leaves, too many list a ball in many of them",
     .acts_with = {"broad_phase", quadtree}},
    {.name = "adaptive_capacity",
     .type = SettingType::integer,
     .initial = 8,
     .min = 1,
     .max = 1000,
     .about = "shapes in a node before it is split; too few split for little, too many are tested in vain",
     .acts_with = {"broad_phase", adaptive}},
    {.name = "adaptive_depth",
     .type = SettingType::integer,
     .initial = 8,
     .min = 1,
     .max = 24,
     .about = "how often the adaptive quadtree splits at most; too few crowd the leaves",
     .acts_with = {"broad_phase", adaptive}},
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

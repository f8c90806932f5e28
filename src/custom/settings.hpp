#pragma once
/// The settings of this engine, read once when a world is created.

#include <cstdint>

#include "world/settings.hpp"

namespace flipside::custom {

[[nodiscard]] std::span<const SettingSpec> setting_specs();

struct SolverSettings {
    std::string_view solver;
    int motion_iterations;
    int collision_iterations;
    bool sleep;
    double sleep_speed;  ///< m/s
    std::uint64_t max_impacts;

    explicit SolverSettings(const Settings& settings);
};

}  // namespace flipside::custom

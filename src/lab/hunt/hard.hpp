#pragma once
/// Scenes that hunts found, in assets/hard: a scene file each, and in hard.json the contender, the kind of
/// error and its size.

#include <filesystem>

#include "lab/hunt/round.hpp"

namespace flipside::lab::hunt {

struct HardScene {
    std::string scene;    ///< file beside hard.json
    Request request;      ///< of it contender, dt, goal and seconds
    double recorded = 0;  ///< its value when it was kept
};

/// Runs are the same to the bit with one build; other compilers' Box2D may round otherwise.
inline constexpr double may_grow = 1.01;

/// Throws InputError with file and pointer for what is no such list.
[[nodiscard]] std::vector<HardScene> hard_scenes(const std::filesystem::path& folder);
/// assets/hard.
[[nodiscard]] std::filesystem::path hard_folder();

}  // namespace flipside::lab::hunt

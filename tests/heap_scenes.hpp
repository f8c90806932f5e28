#pragma once
/// Balls of 0.1 m that lie on each other, for the tests of static heaps.

#include <cmath>

#include "world/scene_builder.hpp"

namespace flipside {

inline constexpr double heap_gravity = 9.81;  ///< m/s²

/// Rows of balls in a V of 60° to each side, so that balls lie in a hexagonal grid against both walls.
inline Scene heap_in_groove(int rows, double friction) {
    Scene scene = empty_scene({0, -heap_gravity});
    scene.materials[0].friction = friction;
    const double rise = std::sqrt(0.75);
    add_part(scene, {shape::Polyline{{{-1.5, 3 * rise}, {0, 0}, {1.5, 3 * rise}}, false}},
             {"", 0.5, friction, 0});
    for (int row = 0; row < rows; ++row)
        for (int k = 0; k <= row; ++k) add_ball(scene, {0.1 * (2 * k - row), 0.2 + 0.2 * rise * row});
    return scene;
}

}  // namespace flipside

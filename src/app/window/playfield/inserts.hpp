#pragma once
/// The lamps let into the ground of a table, by what its rules say: under each rollover, and before each drop
/// target with an arrow towards it.

#include "app/window/camera.hpp"
#include "app/window/canvas.hpp"
#include "app/window/playfield/chart.hpp"
#include "app/window/run.hpp"

namespace flipside::app {

struct Insert {
    PartIndex part = 0;
    Vec2 at;            ///< m, its middle
    Vec2 way;           ///< unit, from the lamp to its target; zero where it is a round one
    double radius = 0;  ///< m
};

/// Every rollover and target of the scene's groups, in their order; of a target's two sides the one with more
/// room before it has the lamp.
[[nodiscard]] std::vector<Insert> inserts_of(const Scene& scene, const Chart& chart);

/// Lit where the game says so.
void draw_inserts(Canvas& canvas, const Camera& camera, std::span<const Insert> inserts, const Run& run);

}  // namespace flipside::app

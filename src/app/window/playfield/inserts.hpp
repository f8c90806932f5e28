#pragma once
/// The lamps let into the ground of a table, by what its rules say: under each rollover, before each drop
/// target with an arrow towards it, and before each group of targets that leads to multiball.

#include "app/window/camera.hpp"
#include "app/window/canvas.hpp"
#include "app/window/playfield/chart.hpp"
#include "app/window/run.hpp"

namespace flipside::app {

struct Insert {
    enum class Kind { rollover, target, bank, times, save };
    Kind kind = Kind::rollover;
    std::size_t of = 0;  ///< the part; of a bank its place among the groups of targets; or how many times
    Vec2 at;             ///< m, its middle
    Vec2 way;            ///< unit, from the lamp of a target or bank towards it
    double radius = 0;   ///< m
};

/// Every rollover and target of the scene's groups, in their order, and a bank's lamp after its targets'; of
/// a target's two sides the one with more room before it has the lamp.
[[nodiscard]] std::vector<Insert> inserts_of(const Scene& scene, const Chart& chart);

/// Lit where the game says so.
void draw_inserts(Canvas& canvas, const Camera& camera, std::span<const Insert> inserts, const Run& run);

}  // namespace flipside::app

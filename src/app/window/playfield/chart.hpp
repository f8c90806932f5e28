#pragma once
/// The drawing on the ground of a table: a chart of how far each place is from the nearest still part, as a
/// nautical chart has depths. The first line is where the centre of a ball that touches lies, the second one
/// a radius farther, and so on. Needs nothing but the scene, so every table has one.

#include <cstdint>
#include <vector>

#include "world/surface.hpp"

namespace flipside::app {

struct Chart {
    /// Of a line of equal depth, between two sides of a cell.
    struct Stroke {
        Vec2 a, b;      ///< m; on the line to rounding, where one part is nearest to both
        int level = 0;  ///< in intervals, from 1
    };

    static constexpr int levels = 12;

    Box box;                    ///< the scene's bounds
    double interval = 0;        ///< m between lines
    double spacing = 0;         ///< m between samples
    int columns = 0, rows = 0;  ///< of samples
    std::vector<double> depth;  ///< m, row by row from the lower left; at most levels + 1 intervals
    std::vector<Stroke> strokes;

    [[nodiscard]] double at(int column, int row) const {
        return depth[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                     static_cast<std::size_t>(column)];
    }
    /// Of the sample nearest to a place.
    [[nodiscard]] double near(Vec2 place) const;
};

/// Whether a part stays where it is for good and is in the way: parts that move, sensors, gates and targets
/// do not.
[[nodiscard]] bool is_coast(const Part& part);

/// Of the scene's coasts. Cost: for every primitive, the samples within the
/// greatest depth of it; there are at most 60,000.
[[nodiscard]] Chart chart_of(const Scene& scene);

}  // namespace flipside::app

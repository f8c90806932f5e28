#pragma once
/// Metres to pixels of a pane and back. Pixels count from the pane's top left corner, y down.

#include "world/scene.hpp"

namespace flipside::app {

struct Camera {
    Vec2 center;       ///< m, shown in the middle of the pane
    double scale = 1;  ///< px per m
    Vec2 size;         ///< px, of the pane

    [[nodiscard]] Vec2 to_pixels(Vec2 p) const {
        return {0.5 * size.x + scale * (p.x - center.x), 0.5 * size.y - scale * (p.y - center.y)};
    }
    [[nodiscard]] Vec2 to_metres(Vec2 pixel) const {
        return {center.x + (pixel.x - 0.5 * size.x) / scale, center.y - (pixel.y - 0.5 * size.y) / scale};
    }

    /// Shows all of `box`, centred, with a margin of `margin` px on every side.
    void fit(const Box& box, double margin);
    /// Zooms by `factor`; what lies under `pixel` stays there. The scale stays within 1 px to 1e6 px per m.
    void zoom(Vec2 pixel, double factor);
    /// Moves the table by so many pixels.
    void pan(Vec2 pixels);

    friend bool operator==(const Camera&, const Camera&) = default;
};

/// What a scene wants to be seen of it.
[[nodiscard]] inline const Box& view_bounds(const Scene& scene) {
    return scene.camera ? *scene.camera : scene.bounds;
}

}  // namespace flipside::app

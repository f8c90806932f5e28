#pragma once
/// Draws the table and the balls of a run into a pane.

#include <optional>

#include "app/window/camera.hpp"
#include "app/window/canvas.hpp"
#include "app/window/run.hpp"
#include "app/window/show.hpp"
#include "world/table.hpp"

namespace flipside::app {

/// A ball that is pulled back, to be thrown.
struct Sling {
    BallNumber ball = 0;
    Vec2 held;      ///< m, where it is pulled to
    Vec2 velocity;  ///< m/s, that it will get

    friend bool operator==(const Sling&, const Sling&) = default;
};

/// How the user wants the table drawn.
struct Look {
    Shows shows{1U << static_cast<unsigned>(Show::lights)};
    bool random_colours = false;    ///< each ball tinted by its number
    bool artwork = true;            ///< chart, caps, shadows, trails and sparks
    bool advice = true;             ///< to the player, who is absent from a film
    double charge = 0;              ///< 0…1, of the launch that is being held
    std::optional<Other> picked{};  ///< stands out
    std::optional<Sling> sling{};

    friend bool operator==(const Look&, const Look&) = default;
};

/// Whether something is drawn over the table that the artwork has to step back for.
[[nodiscard]] bool has_overlays(const Look& look);
/// The ground without artwork.
void draw_bare_ground(Canvas& canvas, const Camera& camera, const Scene& scene);
/// Parts and launcher.
void draw_table(Canvas& canvas, const Camera& camera, const Run& run, const Look& look);
/// Balls of a run, as they are or were. They fade as the engine's own certainty of where they are ends.
void draw_balls(Canvas& canvas, const Camera& camera, const Run& run, std::span<const Ball> balls,
                const Look& look);
/// Only a ring around where each ball is, to be seen together with another run's balls; it fades likewise.
void draw_halos(Canvas& canvas, const Camera& camera, const Run& run, std::span<const Ball> balls);
/// Lines between the same ball in both runs, the fainter the more balls there are.
void draw_links(Canvas& canvas, const Camera& camera, const Run& a, const Run& b, sf::Color color);

}  // namespace flipside::app

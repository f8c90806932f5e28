#include "app/window/playfield/inserts.hpp"

#include <cmath>

#include "app/window/theme.hpp"

namespace flipside::app {

namespace {

struct Extent {
    Vec2 middle;   ///< the average of its ends or corners
    Vec2 longest;  ///< its longest side
};

Extent extent_of(const Shape& shape) {
    if (const auto* segment = std::get_if<shape::Segment>(&shape.is))
        return {0.5 * (segment->a + segment->b), segment->b - segment->a};
    const auto* polygon = std::get_if<shape::Polygon>(&shape.is);
    if (polygon == nullptr) return {};
    Extent extent;
    const auto count = static_cast<double>(polygon->points.size());
    for (std::size_t i = 0; i < polygon->points.size(); ++i) {
        const Vec2 a = polygon->points[i], b = polygon->points[(i + 1) % polygon->points.size()];
        extent.middle = extent.middle + a / count;
        if (length(b - a) > length(extent.longest)) extent.longest = b - a;
    }
    return extent;
}

void add_rollover(std::vector<Insert>& inserts, const Scene& scene, PartIndex part) {
    const Extent extent = extent_of(scene.parts[part].shape);
    if (extent.longest == Vec2{}) return;
    inserts.push_back({part, extent.middle, {}, 0.32 * length(extent.longest)});
}

void add_target(std::vector<Insert>& inserts, const Scene& scene, const Chart& chart, PartIndex part) {
    const Extent extent = extent_of(scene.parts[part].shape);
    if (extent.longest == Vec2{}) return;
    const double size = 0.5 * length(extent.longest), apart = 1.9 * size;
    const Vec2 across = unit(perp(extent.longest));
    const Vec2 one = extent.middle + apart * across, other = extent.middle - apart * across;
    if (chart.near(one) >= chart.near(other))
        inserts.push_back({part, one, -across, size});
    else
        inserts.push_back({part, other, across, size});
}

/// A lens in a dark bezel, with light that spills over it.
void draw_round(Canvas& canvas, Vec2 at, double radius, bool lit) {
    if (lit) canvas.disc(at, 1.7 * radius, with_alpha(colour::lit, 0.12));
    canvas.disc(at, radius, colour::around);
    const double lens = radius - canvas.scaled(1.5);
    if (lens < 1) return;
    canvas.disc(at, lens, lit ? colour::lit : blend(colour::around, colour::lit, 0.16));
    canvas.disc(at, 0.55 * lens, lit ? sf::Color(0xff, 0xf6, 0xdc) : blend(colour::around, colour::lit, 0.1));
}

void draw_arrow(Canvas& canvas, Vec2 at, Vec2 way, double radius, bool lit) {
    const Vec2 aside = perp(way);
    const auto triangle = [&](double size, sf::Color color) {
        const Vec2 corners[] = {at + size * way, at - 0.7 * size * way + 0.8 * size * aside,
                                at - 0.7 * size * way - 0.8 * size * aside};
        canvas.fill(corners, color);
    };
    if (lit) triangle(1.6 * radius, with_alpha(colour::lit, 0.12));
    triangle(radius, colour::around);
    triangle(0.72 * radius, lit ? colour::lit : blend(colour::around, colour::lit, 0.16));
}

}  // namespace

std::vector<Insert> inserts_of(const Scene& scene, const Chart& chart) {
    std::vector<Insert> inserts;
    if (!scene.rules) return inserts;
    for (const Rules::Group& group : scene.rules->lanes)
        for (const PartIndex part : group.parts) add_rollover(inserts, scene, part);
    for (const Rules::Group& group : scene.rules->targets)
        for (const PartIndex part : group.parts) add_target(inserts, scene, chart, part);
    return inserts;
}

void draw_inserts(Canvas& canvas, const Camera& camera, std::span<const Insert> inserts, const Run& run) {
    for (const Insert& insert : inserts) {
        const Vec2 at = camera.to_pixels(insert.at);
        const double radius = camera.scale * insert.radius;
        const bool lit = run.session().game().lit(insert.part);
        if (insert.way == Vec2{})
            draw_round(canvas, at, radius, lit);
        else
            draw_arrow(canvas, at, {insert.way.x, -insert.way.y}, radius, lit);
    }
}

}  // namespace flipside::app

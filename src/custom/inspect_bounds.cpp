#include "custom/inspect_bounds.hpp"

#include "custom/geometry/enclosing.hpp"

namespace flipside::custom {

namespace {

void inspect_turning_bounds(const Layout& layout, const Table& table, Inspector& inspector) {
    std::vector<Vec2> outline;
    for (const PartIndex part : table.moving_parts()) {
        outline.clear();
        for (const Primitive& primitive : layout.primitives())
            if (primitive.part == part) append_outline(primitive, table.pose(part), outline);
        const Disc disc = enclosing_disc(outline);
        inspector.circle(Topic::boxes, disc.center, disc.radius);
        const auto corners = enclosing_rectangle(outline).corners();
        for (std::size_t i = 0; i < 4; ++i) inspector.segment(Topic::boxes, corners[i], corners[(i + 1) % 4]);
    }
}

}  // namespace

void inspect_bounds(const Layout& layout, const Table& table, std::span<const Ball> balls,
                    Inspector& inspector) {
    for (PrimitiveIndex i = 0; i < layout.size(); ++i)
        inspector.box(Topic::boxes, bounds_of(layout.primitive(i), table.pose(layout.primitive(i).part)));
    for (const Ball& ball : balls) inspector.box(Topic::boxes, bounds_of(ball.position, ball.radius));
    inspect_turning_bounds(layout, table, inspector);
}

}  // namespace flipside::custom

// Draws the data of the engine: boxes, cells, pairs, contacts and sleeping balls.

#include "custom/world.hpp"

namespace flipside::custom {

namespace {

Vec2 middle(const Box& box) {
    return 0.5 * (box.min + box.max);
}

/// Draws the boxes of balls and parts.
void inspect_bounds(const Layout& layout, const Table& table, std::span<const Ball> balls,
                    Inspector& inspector) {
    for (PrimitiveIndex i = 0; i < layout.size(); ++i)
        inspector.box(Topic::boxes, bounds_of(layout.primitive(i), table.pose(layout.primitive(i).part)));
    for (const Ball& ball : balls) inspector.box(Topic::boxes, bounds_of(ball.position, ball.radius));
}

}  // namespace

void CustomWorld::inspect(Inspector& inspector) const {
    if (inspector.wants(Topic::boxes)) inspect_bounds(layout_, table_, balls_, inspector);
    if (inspector.wants(Topic::cells) && continuous_) continuous_->inspect_cells(inspector);
    if (inspector.wants(Topic::cells) && simple_) broad_->inspect(inspector);
    if (inspector.wants(Topic::pairs)) {
        find_contacts();
        const auto place = [&](Handle handle) {
            if (handle >= layout_.size()) return balls_[handle - layout_.size()].position;
            const Primitive& primitive = layout_.primitive(handle);
            return middle(bounds_of(primitive, table_.pose(primitive.part)));
        };
        for (const Pair pair : contacts_.pairs()) inspector.pair(place(pair.a), place(pair.b));
    }
    if (inspector.wants(Topic::contacts))
        for (const Contact& contact : contacts()) inspector.contact(contact);
    if (inspector.wants(Topic::sleep))
        for (const Ball& ball : balls_)
            if (ball.asleep) inspector.circle(Topic::sleep, ball.position, ball.radius);
}

}  // namespace flipside::custom

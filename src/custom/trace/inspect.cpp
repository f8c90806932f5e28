// Draws the data of the engine: boxes, cells, pairs, contacts and sleeping balls.

#include "custom/world.hpp"

namespace flipside::custom {

void CustomWorld::inspect(Inspector& inspector) const {
    const auto bounds = [&](const Primitive& primitive) {
        return bounds_of(primitive, table_.pose(primitive.part));
    };
    if (inspector.wants(Topic::boxes)) {
        for (const Primitive& primitive : layout_.primitives())
            inspector.box(Topic::boxes, bounds(primitive));
        for (const Ball& ball : balls_) inspector.box(Topic::boxes, bounds_of(ball.position, ball.radius));
    }
    if (inspector.wants(Topic::cells) && continuous_) continuous_->inspect_cells(inspector);
    if (inspector.wants(Topic::cells) && simple_) broad_->inspect(inspector);
    if (inspector.wants(Topic::pairs)) {
        find_contacts();
        const auto place = [&](Handle handle) {
            if (handle >= layout_.size()) return balls_[handle - layout_.size()].position;
            const Box box = bounds(layout_.primitive(handle));
            return 0.5 * (box.min + box.max);
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

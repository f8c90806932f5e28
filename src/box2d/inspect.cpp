/// What Box2D shows of its insides.

#include "box2d/meeting.hpp"
#include "box2d/world.hpp"

namespace flipside::box2d {

namespace {

/// Draws the leaves of the dynamic tree: boxes fattened so that balls can move a little without leaving.
struct DrawLeaves {
    Inspector& inspector;
    const Units& units;
    const b2BroadPhase& tree;

    bool QueryCallback(int32 proxy) const {
        const b2AABB& box = tree.GetFatAABB(proxy);
        inspector.box(Topic::boxes, {units.point(box.lowerBound), units.point(box.upperBound)});
        return true;
    }
};

}  // namespace

void Box2dWorld::inspect(Inspector& inspector) const {
    if (inspector.wants(Topic::boxes)) {
        const b2BroadPhase& tree = world_->GetContactManager().m_broadPhase;
        DrawLeaves draw{inspector, units_, tree};
        tree.Query(&draw, {{-b2_maxFloat, -b2_maxFloat}, {b2_maxFloat, b2_maxFloat}});
    }
    if (inspector.wants(Topic::pairs))
        for (b2Contact* contact = world_->GetContactList(); contact; contact = contact->GetNext()) {
            const Meeting meeting = Meeting::of(*contact);
            const b2Vec2 surface = meeting.surface.GetAABB(0).GetCenter();
            inspector.pair(units_.point(meeting.ball.GetBody()->GetPosition()), units_.point(surface));
        }
    if (inspector.wants(Topic::contacts))
        for (const Contact& contact : contacts()) inspector.contact(contact);
    if (inspector.wants(Topic::sleep))
        for (const Ball& ball : balls_)
            if (ball.asleep) inspector.circle(Topic::sleep, ball.position, ball.radius);
}

}  // namespace flipside::box2d

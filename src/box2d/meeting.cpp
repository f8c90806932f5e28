#include "box2d/meeting.hpp"

#include <box2d/b2_collision.h>

namespace flipside::box2d {

std::optional<Touch> touch_of(b2Contact& contact, const Meeting& meeting, const b2Manifold& manifold) {
    if (manifold.pointCount == 0) return std::nullopt;
    const b2Fixture &a = *contact.GetFixtureA(), &b = *contact.GetFixtureB();
    const b2Transform &at_a = a.GetBody()->GetTransform(), &at_b = b.GetBody()->GetTransform();
    // Edges and polygons are always fixture A, and a ball's centre is its body's origin.
    if (at_joint(a, manifold, b2MulT(at_a, at_b.p))) return std::nullopt;
    b2WorldManifold world;
    world.Initialize(&manifold, at_a, a.GetShape()->m_radius, at_b, b.GetShape()->m_radius);
    return Touch{world.points[0], meeting.ball_is_b ? world.normal : -world.normal, world.separations[0]};
}

std::optional<Touch> touch_of(b2Contact& contact, const Meeting& meeting) {
    b2Manifold manifold;
    contact.Evaluate(&manifold, contact.GetFixtureA()->GetBody()->GetTransform(),
                     contact.GetFixtureB()->GetBody()->GetTransform());
    return touch_of(contact, meeting, manifold);
}

}  // namespace flipside::box2d

#pragma once
/// Primitives of a scene's surface as Box2D shapes.
///
///     point            circle of radius 0
///     segment          edge, two-sided
///     arc              edges, two-sided: chords with their ends on the arc
///     circle           circle
///     polygon          polygon; with more corners than Box2D's 8, a loop of one-sided edges (a fan of
///                      polygons where it is a sensor)
///     taper            polygon between the tangent points and two circles
///
/// Two choices keep this as near to the exact geometry as Box2D allows:
///
/// - Skin. Box2D rounds edges and polygons by b2_polygonRadius (0.01 units) so that polygons do not fall
///   through one another. Discs do not need it, and with it every wall stands 0.01 units out (0.5 mm on a
///   pinball table), so m_radius is 0 here. What stays is Box2D's own softness: it lets shapes overlap by
///   b2_linearSlop (0.005 units) at rest and by 3 slops at the moment of a continuous hit.
/// - Joints. A two-sided Box2D edge also collides with its ends, which would catch a ball that rolls over
///   a smooth joint, and one-sided edges would need two per wall. So edges keep two sides, carry ghost
///   vertices like one-sided ones, and at_joint() tells which contacts to ignore: those with an end that
///   the neighbour beyond it covers. A ghost that continues an end straight on makes that end vanish; the
///   ends that can be hit are primitives of their own.

#include <box2d/b2_fixture.h>

#include "box2d/units.hpp"
#include "world/events.hpp"
#include "world/surface.hpp"

namespace flipside::box2d {

/// What a fixture belongs to, kept in its user data.
struct Tag {
    Other owner;
    bool cornerless = false;  ///< corners of this polygon are covered by other shapes of the part

    [[nodiscard]] std::uintptr_t packed() const {
        return std::uintptr_t{owner.index} << 2 | (cornerless ? 2U : 0U) | (owner.is_ball ? 1U : 0U);
    }
    static Tag of(const b2Fixture& fixture) {
        const std::uintptr_t bits = const_cast<b2Fixture&>(fixture).GetUserData().pointer;
        return {{(bits & 1U) != 0, static_cast<std::uint32_t>(bits >> 2)}, (bits & 2U) != 0};
    }
};

/// Adds a primitive to a body whose frame is `frame`. Arcs stray from their chords by at most `chord_error`
/// m.
void add_primitive(b2Body& body, const Primitive& primitive, bool sensor, const Units& frame,
                   double chord_error);

/// Whether a contact of a disc with this fixture is one to ignore, see above. `center` is the disc's, in
/// the coordinates of the fixture's body; the manifold is one of that fixture (as A) and the disc (as B).
[[nodiscard]] bool at_joint(const b2Fixture& fixture, const b2Manifold& manifold, b2Vec2 center);

}  // namespace flipside::box2d

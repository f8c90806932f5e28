#pragma once
/// The two bodies of a Box2D contact, in the terms of the World interface.

#include <optional>

#include <box2d/b2_body.h>
#include <box2d/b2_contact.h>

#include "box2d/shapes.hpp"

namespace flipside::box2d {

/// One side is always a ball. Between two balls `ball` is the one with the lower number.
struct Meeting {
    b2Fixture& ball;
    b2Fixture& surface;      ///< of a part or of the other ball
    BallNumber number = 0;   ///< of the ball
    Other other;             ///< whose surface it is
    bool ball_is_b = false;  ///< the ball is the contact's fixture B

    static Meeting of(b2Contact& contact) {
        b2Fixture &a = *contact.GetFixtureA(), &b = *contact.GetFixtureB();
        const Other owner_a = Tag::of(a).owner, owner_b = Tag::of(b).owner;
        const bool ball_is_b = !owner_a.is_ball || (owner_b.is_ball && owner_b.index < owner_a.index);
        return ball_is_b ? Meeting{b, a, owner_b.index, owner_a, true}
                         : Meeting{a, b, owner_a.index, owner_b, false};
    }
    [[nodiscard]] bool sensor() const { return surface.IsSensor(); }
};

/// Where two surfaces touch, in Box2D's units.
struct Touch {
    b2Vec2 point;   ///< midway between the surfaces
    b2Vec2 normal;  ///< unit, from the surface to the ball
    float separation = 0;
};

/// What Box2D's narrow phase says of a contact's bodies as they stand now; nothing where they are apart or
/// meet at a joint (shapes.hpp).
[[nodiscard]] std::optional<Touch> touch_of(b2Contact& contact, const Meeting& meeting);
/// The same from the contact's own manifold.
[[nodiscard]] std::optional<Touch> touch_of(b2Contact& contact, const Meeting& meeting,
                                            const b2Manifold& manifold);

}  // namespace flipside::box2d

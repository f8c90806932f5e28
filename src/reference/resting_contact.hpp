#pragma once
/// A ball that touches a surface without moving into it or off it: what force would keep it there, how
/// friction acts, and the path that it takes along the surface.
///
/// The centre of a ball on a line is at pivot + s·τ + d·n, on a curve at centre + L·o, in a frame that turns
/// with the part (rate ω). With damping c and gravity g, per mass:
///     line:   normal force  N = 2ωs' − ω²d − n·g + c·ω·s,      along it  s'' = ω²s + τ·g − c·(s' − ωd) + F
///     curve:  N = −σ(o·e + Lφ'²),  Lφ'' = τ·e − cLφ' + F,      e = g − C'' − c·C',  σ = o·n
/// where C is the path of the centre of the curve.
/// F is friction: µN against the slip while it slides; when it rolls, minus a third of the tangential force
/// (a disc resists with half its mass). Signs of spin: slip = (v − surface)·τ − σ·r·spin, with σ = −1 on a
/// line.

#include "reference/time_of_impact.hpp"

namespace flipside::reference {

template <class R>
struct Body {
    V<R> position, velocity;
    R angle{}, spin{}, radius{};
};
/// m: rounding of the position. Bounces lower than that are rest.
template <class R>
R rounding_of(const Body<R>& body) {
    return epsilon<R>() * (length(body.position) + body.radius);
}

template <class R>
struct ExternalForces {
    V<R> gravity;
    R drag{};
};

template <class R>
struct RestingContact {
    const Feature<R>* feature = nullptr;  ///< in the frame of `turning`
    const Turning<R>* turning = nullptr;  ///< null for a static part
    bool straight = false;
    V<R> normal, tangent;     ///< unit; from the surface to the ball, and across
    V<R> pivot;               ///< the frame's; a point of the feature where that stands still
    R rate{};                 ///< ω
    R along{}, offset{};      ///< line: s, d
    V<R> arm, out;            ///< curve: centre − pivot, o
    R length{}, side{};       ///< L, σ
    R separating_speed{};     ///< normal speed of the ball against the surface, positive off it
    R tangential_speed{};     ///< s' or Lφ'
    R slip{}, friction{};     ///< m/s, µ
    R force{}, tangential{};  ///< N needed to stay; tangential acceleration but for friction, m/s²
};

/// The contact at a feature that the ball touches; `normal` as closest_point() gives it. Distances within
/// `snap` of touching become exactly that.
template <class R>
[[nodiscard]] RestingContact<R> resting_contact_at(const Feature<R>& feature, const Turning<R>* turning,
                                                   const Body<R>& ball, const R& time, const R& friction,
                                                   const ExternalForces<R>& external, const R& snap);

/// How friction acts at a contact.
enum class FrictionMode { frictionless, slides, rolls };
template <class R>
struct ContactFriction {
    FrictionMode mode = FrictionMode::frictionless;
    R force{};            ///< per mass, along the tangent
    R sign{};             ///< of the slip, while it slides
    bool begins = false;  ///< to slide: there is no slip yet
};
template <class R>
[[nodiscard]] ContactFriction<R> friction_of(const RestingContact<R>& contact, const Body<R>& ball);

/// The path along one surface.
template <class R>
struct ConstrainedPath {
    Path<R> path;
    R until = infinity<R>();  ///< end of the path, not after `last`
    bool separates = false;   ///< whether the contact ends at `until`
};
/// From `time` to `last` at most.
template <class R>
[[nodiscard]] ConstrainedPath<R> constrain(const RestingContact<R>& contact,
                                           const ContactFriction<R>& contact_friction, const Body<R>& ball,
                                           const R& time, const R& last, const ExternalForces<R>& external);

}  // namespace flipside::reference

#pragma once
/// A resting contact: the constrained path of a ball on a surface, and when the two separate.
///
/// On a straight static face the path is a flight along the face with the tangential part of gravity. On a
/// curved face the ball moves like a pendulum; on a turning face the equations are those of the turning
/// frame. These paths have no closed form. They are expanded in a Taylor series by recurrences for products,
/// sine and cosine (Jorba and Zou 2005, "A software package for the numerical integration of ODEs by means of
/// high-order Taylor methods"). The series is used only as long as its last terms are below 1e-17 of the
/// ball's radius. Cost: about 2 µs per series.
///
/// With friction the ball slides under Coulomb's force until the slip is 0. Then it rolls, with two thirds of
/// the acceleration (for a disc), as long as a third of the tangential force stays below µ times the normal
/// force. The change between sliding and rolling is an event.
///
/// The contact ends when the normal force changes sign, and at the end of the face.

#include "custom/continuous/feature.hpp"
#include "custom/continuous/path.hpp"
#include "custom/continuous/time_of_impact.hpp"
#include "world/ball.hpp"

namespace flipside::custom {

/// The forces on a ball in free flight.
struct ExternalForces {
    Vec2 gravity;     ///< m/s²
    double drag = 0;  ///< 1/s
};

/// The contact of a ball with a surface at one instant.
struct RestingContact {
    const Feature* feature = nullptr;
    const Turning* turning = nullptr;
    Vec2 normal;            ///< unit, from the surface to the ball
    Vec2 surface_velocity;  ///< at the point of contact, m/s
    double force = 0;       ///< normal force per mass that keeps the ball on the surface, m/s²
    double tangential = 0;  ///< force per mass along perp(normal) without friction, m/s²
    double friction = 0;    ///< µ between the two
    bool loaded = false;    ///< the force is more than rounding
};

/// The contact of a ball that touches the feature at `time`, with the normal that closest_point() gives.
[[nodiscard]] RestingContact resting_contact_at(const Feature& feature, const Turning& turning,
                                                const Ball& ball, Vec2 normal, double time,
                                                const ExternalForces& external);

/// Friction force per mass on a resting ball, along perp(normal), m/s².
[[nodiscard]] double friction_of(const RestingContact& contact, const Ball& ball);

struct ConstrainedPath {
    Path path;
    double until = never_touch;  ///< end of this path; never_touch if not before t1
    double spin_rate = 0;        ///< rad/s², of a ball that slides along a static line
    Vec2 roll;                   ///< for a ball that rolls there: the spin is dot(roll, velocity)
    bool separates = false;      ///< whether the contact ends at `until`

    /// Resets all to a flight from `time` on.
    void fly(const Flight& flight, double time);
};

/// Finds the path of a resting ball from `time`, without its normal speed relative to the surface. Returns
/// false if the search for the end of the path took too many steps; then the path must not be used.
[[nodiscard]] bool constrain(const RestingContact& contact, const Ball& ball, double time, double t1,
                             const ExternalForces& external, ConstrainedPath& motion);

}  // namespace flipside::custom

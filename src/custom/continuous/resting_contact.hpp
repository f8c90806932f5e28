#pragma once
/// A resting contact: the path of a ball that stays on a surface, and when it separates.
///
/// On a straight still face the path is a flight along the face with what gravity leaves of itself there.
/// On a curved face the ball is a pendulum; on a turning one the same in the turning frame. Those have no
/// closed form; their motion is expanded in a Taylor series whose terms follow from one another
/// (recurrences for products, sine and cosine; Jorba and Zou 2005, "A software package for the numerical
/// integration of ODEs by means of high-order Taylor methods") and used only as long as its last terms are
/// below 1e-17 of the ball's radius. Cost: about 2 µs per series.
///
/// With friction the ball slides under Coulomb's force until the slip is gone, and then rolls (with two
/// thirds of the acceleration, for a disc) as long as a third of what drives it stays below µ times the
/// normal force. The switch is an event like any other.
///
/// Ball and surface separate when the force that keeps the ball on the surface changes sign, and where the
/// face ends.

#include "custom/continuous/feature.hpp"
#include "custom/continuous/path.hpp"
#include "custom/continuous/time_of_impact.hpp"
#include "world/ball.hpp"

namespace flipside::custom {

/// What drives a ball.
struct Drive {
    Vec2 gravity;
    double drag = 0;
};

/// A ball on a surface at an instant.
struct RestingContact {
    const Feature* feature = nullptr;
    const Turning* turning = nullptr;
    Vec2 normal;            ///< unit, from the surface to the ball
    Vec2 surface_velocity;  ///< where they touch
    double force = 0;       ///< per mass, needed along the normal to keep the ball on the surface, m/s²
    double driven = 0;      ///< per mass, what acts along perp(normal) but for friction, m/s²
    double friction = 0;    ///< µ between the two
};

/// The contact of a ball that touches the feature at `time`; `normal` as closest_point() and the pose give
/// it.
[[nodiscard]] RestingContact resting_contact_at(const Feature& feature, const Turning& turning,
                                                const Ball& ball, Vec2 normal, double time,
                                                const Drive& drive);

/// What friction does to a ball that the contact holds, per mass along perp(normal), m/s².
[[nodiscard]] double friction_of(const RestingContact& contact, const Ball& ball);

struct ConstrainedPath {
    Path path;
    double until = never_touch;  ///< must be looked at again then; never_touch if not before t1
    double spin_rate = 0;        ///< rad/s², of a ball that slides along a still line
    Vec2 roll;                   ///< of one that rolls there: its spin is this times its velocity
    bool separates = false;      ///< because the contact ends there

    /// Begins anew, with a flight from `time` on.
    void fly(const Flight& flight, double time);
    /// The spin at `time` of a ball that began the path with `spin`.
    [[nodiscard]] double spin_at(double spin, double time) const;
};

/// The path of a resting ball from `time`; its normal speed against the surface is taken out. False when the
/// search for its end took too many steps; then the path is good for nothing.
[[nodiscard]] bool constrain(const RestingContact& contact, const Ball& ball, double time, double t1,
                             const Drive& drive, ConstrainedPath& held);

}  // namespace flipside::custom

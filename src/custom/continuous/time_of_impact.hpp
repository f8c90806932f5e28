#pragma once
/// Time of impact: the first instant at which a disc on its path touches a feature of the table or another
/// disc, or leaves a box. Pure geometry; the continuous narrow phase.
///
/// There are two kinds of method, tested against each other. Straight relative motion, and parabolas against
/// lines, lead to quadratic equations, and two different accelerations to a quartic; with drag, the distance
/// of a flight from a line is still convex or concave throughout. All other cases use conservative
/// advancement of second order (after Mirtich 1996), which skips no root in its first 5,000 steps: the gap
/// f(t) has f'' ≥ −K, so f stays positive for h = (f' + √(f'² + 2Kf))/K; the search advances by h until f is
/// rounding. Its steps converge quadratically to a crossing and linearly to a grazing contact. In the frame
/// of a part that turns at ω, f'' is bounded by |a| + 2|ω||v| + ω²|p − pivot| + v²/d (d: distance from the
/// centre of a curved feature).
///
/// An impact needs an approach speed greater than rounding. Contacts that slide or separate are no impacts,
/// and an overlap that decreases is none until it increases again (Bannerman, Strobl, Formella and Pöschel
/// 2014, "Stable algorithm for event detection in event-driven particle dynamics"). The gap may have any sign
/// at the start; a gap of the size of rounding counts as 0.

#include <cstdint>
#include <utility>

#include "custom/continuous/feature.hpp"
#include "custom/continuous/path.hpp"
#include "custom/geometry/roots.hpp"
#include "custom/tolerances.hpp"

namespace flipside::custom {

/// Relative size of the rounding that an approach speed may carry without meaning an approach.
inline constexpr double speed_rounding = 1e-13;

/// Rounding of a gap at position p: smaller gaps count as contact.
inline double gap_rounding(Vec2 p, double radius) {
    return 16 * 0x1p-53 * (std::abs(p.x) + std::abs(p.y) + radius);
}

inline double gap_rounding(Vec2 p, Vec2 q, double radii) {
    return std::max(gap_rounding(p, radii), gap_rounding(q, radii));
}

/// Time at which a point at d with constant velocity v touches a disc of radius `reach` about the origin;
/// never_touch if it slides or moves away. A gap up to `rounding` is contact.
[[nodiscard]] double straight_touch(Vec2 d, Vec2 v, double reach, double rounding);

/// First impact in [t0, t1], or never_touch; by the closed form if there is one. A search takes up to 10,000
/// steps and adds their number to `steps`.
[[nodiscard]] double time_of_impact(const Feature& feature, const Turning& turning, const Path& path,
                                    double radius, double t0, double t1, std::uint64_t& steps);
[[nodiscard]] double time_of_impact(const Path& a, const Path& b, double radii, double t0, double t1,
                                    std::uint64_t& steps);

/// The same, always by search.
[[nodiscard]] double search_impact(const Feature& feature, const Turning& turning, const Path& path,
                                   double radius, double t0, double t1, std::uint64_t& steps);
[[nodiscard]] double search_impact(const Path& a, const Path& b, double radii, double t0, double t1,
                                   std::uint64_t& steps);

/// Conservative advancement: the first t in [t0, t1] at which `free_time(t)`, a time for which nothing
/// happens after t, is 0 or rounding; never_touch if there is none. Each step counts down `steps_left`; below
/// 0 the search was given up.
double conservative_advancement(auto&& free_time, double t0, double t1, int& steps_left) {
    for (double t = t0; t <= t1 && steps_left-- > 0;) {
        const double before = std::exchange(t, t + free_time(t));
        if (t <= before) return before;
    }
    return never_touch;
}

/// When the point of contact of a ball that rests on the feature reaches an end of it, in [t0, t1], or
/// never_touch. An end nearer than rounding counts as reached if the point moves towards it.
[[nodiscard]] double end_of_face(const Feature& feature, const Turning& turning, const Path& path,
                                 double radius, double t0, double t1, int& steps_left);

/// First time in [t0, t1] at which box.contains(path.position(t)) is false, to one rounding of the time, or
/// never_touch. Both coordinates are monotone between the instants at which one of them may have an extremum,
/// so the path leaves in such an interval only if it is outside at its end; then bisection finds the time.
/// There is no stepping, so a ball that touches the border costs no more than others. Cost: up to four
/// positions for a flight that stays inside, up to about 0.5 ms for a Taylor polynomial (all zeros of the
/// derivatives of both coordinates).
[[nodiscard]] double first_exit(const Path& path, const Box& box, double t0, double t1);

}  // namespace flipside::custom

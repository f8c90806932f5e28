#pragma once
/// Time of impact: the first instant at which a disc on its path touches a feature of the table or another
/// disc. Pure geometry; the continuous narrow phase.
///
/// There are two methods, tested against each other. Straight relative motion, and parabolas against lines,
/// lead to quadratic equations; with drag, the distance of a flight from a line is still convex or concave
/// throughout. All other cases use conservative advancement of second order (after Mirtich 1996), which
/// cannot skip a root: the gap f(t) has f'' ≥ −K, so f stays positive for h = (f' + √(f'² + 2Kf))/K; the
/// search advances by h until f is rounding. Its steps converge quadratically to a crossing and linearly to a
/// grazing contact. In the frame of a part that turns at ω, f'' is bounded by |a| + 2|ω||v| + ω²|p − pivot| +
/// v²/d (d: distance from the centre of a curved feature).
///
/// An impact needs an approach speed greater than rounding. Contacts that slide or separate are no impacts,
/// and an overlap that decreases is none until it increases again (Bannerman, Strobl, Formella and Pöschel
/// 2014, "Stable algorithm for event detection in event-driven particle dynamics"). The gap may have any sign
/// at the start; a gap of the size of rounding counts as 0.

#include <cstdint>

#include "custom/continuous/feature.hpp"
#include "custom/continuous/path.hpp"
#include "world/table.hpp"

namespace flipside::custom {

/// How a part turns during a window: at `rate` until `stop`, then not at all. Times are those of the window.
struct Turning {
    Pose begin;
    double rate = 0;
    double stop = 0;
    double end_angle = 0;  ///< from `stop` on

    [[nodiscard]] bool still() const { return rate == 0; }
    [[nodiscard]] Pose pose(double time) const {
        return {begin.pivot, time < stop ? begin.angle + rate * time : end_angle};
    }
    [[nodiscard]] double rate_at(double time) const { return time < stop ? rate : 0; }
};

inline constexpr double never_touch = INFINITY;

/// Relative size of the rounding that an approach speed may carry without meaning an approach.
inline constexpr double speed_rounding = 1e-13;

/// Rounding of a gap at position p: smaller gaps count as contact.
inline double gap_rounding(Vec2 p, double radius) {
    return 16 * 0x1p-53 * (std::abs(p.x) + std::abs(p.y) + radius);
}

inline double gap_rounding(Vec2 p, Vec2 q, double radii) {
    return std::max(gap_rounding(p, radii), gap_rounding(q, radii));
}

/// Safety margin around a ball, m, greater than touch_distance and rounding: features farther away have no
/// contact.
[[nodiscard]] inline double clearance_margin(const Ball& ball) {
    return 1e-3 * ball.radius + joint_distance +
           1e-12 * (std::abs(ball.position.x) + std::abs(ball.position.y));
}

/// Time at which a point at d with constant velocity v touches a disc of radius `reach` about the origin;
/// never_touch if it slides or moves away. A gap up to `rounding` is contact.
[[nodiscard]] double straight_touch(Vec2 d, Vec2 v, double reach, double rounding);

/// First impact in [t0, t1], or never_touch; by the closed form if there is one. A search takes up to 10,000
/// steps and adds their number to `steps`.
[[nodiscard]] double time_of_impact(const Feature& feature, const Turning& turning, const Path& path,
                                    double radius, double t0, double t1, std::uint64_t* steps = nullptr);
[[nodiscard]] double time_of_impact(const Path& a, const Path& b, double radii, double t0, double t1,
                                    std::uint64_t* steps = nullptr);

/// The same, always by search.
[[nodiscard]] double search_impact(const Feature& feature, const Turning& turning, const Path& path,
                                   double radius, double t0, double t1, std::uint64_t* steps = nullptr);
[[nodiscard]] double search_impact(const Path& a, const Path& b, double radii, double t0, double t1,
                                   std::uint64_t* steps = nullptr);

/// First t ≥ 0 at which gap + rate·t + ½·bend·t² is ≤ 0 and decreasing, or never_touch. A negative gap that
/// increases does not count until it decreases again.
[[nodiscard]] double first_crossing(double gap, double rate, double bend);
/// The same for gap + rate·E(t) + bend·F(t) (flight.hpp); with drag by about four Newton steps.
[[nodiscard]] double first_crossing(double gap, double rate, double bend, double drag);
/// Time for which a function ≥ 0 stays so at least, given its slope and K ≥ |second derivative|.
[[nodiscard]] double safe_time(double value, double slope, double k);

}  // namespace flipside::custom

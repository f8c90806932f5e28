#pragma once
/// Time of impact: the first instant at which a disc on its path touches a feature of the table or
/// another disc. Pure geometry; the narrow phase, with time in it.
///
/// Two ways, tested against each other. Straight relative motion and parabolas against lines have closed
/// quadratics; with drag a flight's distance from a line is still convex or concave throughout. Everything
/// else uses a search that cannot skip a root: the gap f(t) has f'' ≥ −K, so from f and f' the time  h = (f'
/// + √(f'² + 2Kf))/K  is surely free; the search moves on by h until f is rounding. Its steps are Newton's
/// from the safe side: they converge quadratically to a crossing, and linearly to a graze. In the frame of a
/// part that turns at ω, f'' is bounded by |a| + 2|ω||v| + ω²|p − pivot| + v²/d (d: distance from the centre
/// of a curved feature).
///
/// A touch is approached at more than rounding: contacts that slide along or part give no touch, and an
/// overlap that parts gives none until it turns (Bannerman, Strobl, Formella and Pöschel 2014, "Stable
/// algorithm for event detection in event-driven particle dynamics"). The gap may have any sign at the
/// beginning; one of mere rounding counts as none.

#include <cstdint>

#include "custom/continuous/feature.hpp"
#include "custom/continuous/path.hpp"
#include "world/table.hpp"

namespace flipside::custom {

/// How a part turns during a step: at `rate` until `stop`, then not at all. Times of the step.
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

/// Gaps smaller than this cannot be told from contact at a position p.
inline double gap_rounding(Vec2 p, double radius) {
    return 16 * 0x1p-53 * (std::abs(p.x) + std::abs(p.y) + radius);
}

inline double gap_rounding(Vec2 p, Vec2 q, double radii) {
    return std::max(gap_rounding(p, radii), gap_rounding(q, radii));
}

/// Balls surely fly free only where they stay so far from everything, m: well over what any touch or rounding
/// counts as contact.
[[nodiscard]] inline double clearance_margin(const Ball& ball) {
    return 1e-3 * ball.radius + joint_distance +
           1e-12 * (std::abs(ball.position.x) + std::abs(ball.position.y));
}

/// A point at d in straight motion at v against a disc of radius `reach` about the origin: when it touches,
/// or never_touch when it only slides or moves away. A gap up to `rounding` is contact.
[[nodiscard]] double straight_touch(Vec2 d, Vec2 v, double reach, double rounding);

/// First touch in [t0, t1], or never_touch. By the closed form where there is one. A search of up to 10,000
/// steps adds their number to `steps`.
[[nodiscard]] double time_of_impact(const Feature& feature, const Turning& turning, const Path& path,
                                    double radius, double t0, double t1, std::uint64_t* steps = nullptr);
[[nodiscard]] double time_of_impact(const Path& a, const Path& b, double radii, double t0, double t1,
                                    std::uint64_t* steps = nullptr);

/// The same by search alone.
[[nodiscard]] double search_impact(const Feature& feature, const Turning& turning, const Path& path,
                                   double radius, double t0, double t1, std::uint64_t* steps = nullptr);
[[nodiscard]] double search_impact(const Path& a, const Path& b, double radii, double t0, double t1,
                                   std::uint64_t* steps = nullptr);

/// First t ≥ 0 at which gap + rate·t + ½·bend·t² is ≤ 0 and falling, or never_touch. Gaps below 0 count as
/// above until they turn.
[[nodiscard]] double first_fall(double gap, double rate, double bend);
/// The same of gap + rate·E(t) + bend·F(t) (flight.hpp): with drag by Newton's steps, about four.
[[nodiscard]] double first_fall(double gap, double rate, double bend, double drag);
/// Time during which a function ≥ 0 surely stays so, given its slope and K ≥ |second derivative|.
[[nodiscard]] double surely_free(double value, double slope, double k);

}  // namespace flipside::custom

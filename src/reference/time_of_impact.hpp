#pragma once
/// Time of impact, exact to rounding. Undamped flights and static features lead to polynomials
/// (polynomial.hpp); the relative path of two balls with equal forces is straight; all other cases use
/// certified steps (root_search.hpp).

#include "reference/feature.hpp"
#include "reference/root_search.hpp"
#include "reference/view.hpp"

namespace flipside::reference {

/// Size of rounding of a speed, for the scale `speed`.
template <class R>
R rounding_speed(const R& speed) {
    return 256 * epsilon<R>() * speed;
}

/// Rounding of a gap, m. Where an impact is searched for, it may be found late by that much.
template <class R>
R gap_rounding(const V<R>& position, const R& radius) {
    return 16 * epsilon<R>() * (length(position) + radius);
}

/// Result of a closest-point query.
template <class R>
struct Closest {
    R gap{};             ///< of a ball of the given radius, m
    V<R> normal;         ///< unit, from the feature to the point
    bool facing = true;  ///< whether the closest point of the line or circle belongs to the feature
};
template <class R>
[[nodiscard]] Closest<R> closest_point(const Feature<R>& feature, const V<R>& point, const R& radius);

/// First time in [from, until] at which the ball touches the feature and moves into it; never otherwise. The
/// feature is in the pose that the view sees it in. Counts in `grazes` what was decided in a wider type.
template <class R>
[[nodiscard]] R time_of_impact(const Feature<R>& feature, const View<R>& view, const R& radius, const R& from,
                               const R& until, std::uint64_t& grazes);

/// The same for two balls whose radii add up to `reach`.
template <class R>
[[nodiscard]] R time_of_impact(const Path<R>& a, const Path<R>& b, const R& reach, const R& from,
                               const R& until, std::uint64_t& grazes);

/// First time in [from, until] at which the path leaves the box; `side` is which way (0 left, 1 right,
/// 2 down, 3 up). Sides at infinity are never reached.
template <class R>
[[nodiscard]] R leaves(const Path<R>& path, const Box& box, const R& from, const R& until, int& side);

/// Whether the circle continues the face smoothly at an end, so that a ball that slides off the face touches
/// the circle without an approach speed. Both in the same pose.
template <class R>
[[nodiscard]] bool ends_in(const Feature<R>& face, const Feature<R>& circle, const V<R>& normal,
                           const R& radius);

/// Whether the whole feature lies below the line through `at` with the unit normal `normal`, to rounding. A
/// ball that flies along a face without a contact force cannot touch such a feature, but rounding could give
/// a grazing contact with an end cap that continues the face. Tests the full circle of an arc; returns false
/// for a line.
template <class R>
[[nodiscard]] bool lies_below(const Feature<R>& feature, const V<R>& at, const V<R>& normal);

/// Whether the ball has just passed an end of the face, to rounding. The next face supports it there,
/// although rounding may put it on both.
template <class R>
[[nodiscard]] bool comes_off(const Feature<R>& face, const Motion<R>& motion, const R& radius);

/// First time in [from, until] at which the ball leaves the range that a line or arc faces.
template <class R>
[[nodiscard]] R leaves_face(const Feature<R>& feature, const View<R>& view, const R& radius, const R& from,
                            const R& until);

}  // namespace flipside::reference

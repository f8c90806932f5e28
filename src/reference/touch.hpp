#pragma once
/// When does a ball first touch something? Exact to rounding: undamped flights against what stands still are
/// polynomials (polynomial.hpp), balls in like flight move past each other in a straight line, and all else
/// is searched by certified steps (fall.hpp).

#include "reference/fall.hpp"
#include "reference/feature.hpp"
#include "reference/view.hpp"

namespace flipside::reference {

/// A speed that is rounding where `speed` is the scale.
template <class R>
R rounding_speed(const R& speed) {
    return 256 * epsilon<R>() * speed;
}

/// How a point lies to a feature.
template <class R>
struct Closest {
    R gap{};             ///< of a ball of the given radius, m
    V<R> normal;         ///< unit, from the feature to the point
    bool facing = true;  ///< the nearest point of the (endless) line or circle is part of the feature
};
template <class R>
[[nodiscard]] Closest<R> closest_point(const Feature<R>& feature, const V<R>& point, const R& radius);

/// First time in [from, until] at which the ball touches the feature and moves into it; never otherwise. The
/// feature is in the pose that the view sees it in. Counts in `grazes` what was decided in a wider type.
template <class R>
[[nodiscard]] R first_touch(const Feature<R>& feature, const View<R>& view, const R& radius, const R& from,
                            const R& until, std::uint64_t& grazes);

/// The same for two balls whose radii add up to `reach`.
template <class R>
[[nodiscard]] R first_touch(const Path<R>& a, const Path<R>& b, const R& reach, const R& from, const R& until,
                            std::uint64_t& grazes);

/// First time in [from, until] at which the path leaves the box; `side` is which way (0 left, 1 right,
/// 2 down, 3 up). Sides at infinity are never reached.
template <class R>
[[nodiscard]] R leaves(const Path<R>& path, const Box& box, const R& from, const R& until, int& side);

/// Whether a ball that slides to an end of the face meets the round there without any approach, as it does
/// where the round is the end itself, or goes on smoothly. Both in the same pose.
template <class R>
[[nodiscard]] bool ends_in(const Feature<R>& face, const Feature<R>& round, const V<R>& normal,
                           const R& radius);

/// Whether the whole feature lies below the line through `at` with the unit normal `normal`, to rounding. A
/// ball in free flight along a face, which it touches without pressing on it, cannot touch what does;
/// rounding would have it graze an end cap that continues the face. Of an arc its circle counts; of a line
/// this says false.
template <class R>
[[nodiscard]] bool lies_below(const Feature<R>& feature, const V<R>& at, const V<R>& normal);

/// Whether the ball is just off an end of the face, to rounding, on its way out. What holds it goes on from
/// there, though rounding may have both faces under it.
template <class R>
[[nodiscard]] bool comes_off(const Feature<R>& face, const Motion<R>& motion, const R& radius);

/// First time in [from, until] at which the ball leaves the range that a line or arc faces.
template <class R>
[[nodiscard]] R leaves_face(const Feature<R>& feature, const View<R>& view, const R& radius, const R& from,
                            const R& until);

}  // namespace flipside::reference

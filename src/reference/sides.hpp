#pragma once
/// The sides of a feature on which a ball can be: the gap to each, its bounds along a path, and whether the
/// ball faces the feature or is past one of its ends. All in the pose in which the feature is seen; m, m/s.

#include <algorithm>

#include "reference/feature.hpp"
#include "reference/polynomial.hpp"
#include "reference/root_search.hpp"
#include "reference/view.hpp"

namespace flipside::reference {

/// Distance of a point from each end of a face, negative past the end, and the rates of change.
template <class R>
struct Ends {
    Value<R> first, last;
};
template <class R>
Ends<R> within_ends(const Line<R>& line, const Motion<R>& m, const R& radius) {
    const R s = dot(m.position - line.start, line.along), slope = dot(m.velocity, line.along);
    return {{s + line.before.of(radius), slope}, {line.length + line.past.of(radius) - s, -slope}};
}
template <class R>
Ends<R> within_ends(const Curve<R>& curve, const Motion<R>& m, const R& radius) {
    const V<R> out = m.position - curve.center;
    return {{cross(curve.from, out) + curve.before.of(radius), cross(curve.from, m.velocity)},
            {cross(out, curve.to) + curve.past.of(radius), cross(m.velocity, curve.to)}};
}

/// Whether the point is between both ends; for an arc of more than half a turn, inside either.
template <class R>
Value<R> within(const Line<R>& line, const Motion<R>& m, const R& radius) {
    const Ends<R> ends = within_ends(line, m, radius);
    return ends.first.value < ends.last.value ? ends.first : ends.last;
}
template <class R>
Value<R> within(const Curve<R>& curve, const Motion<R>& m, const R& radius) {
    if (curve.full) return {R(1), R(0)};
    const Ends<R> ends = within_ends(curve, m, radius);
    return (ends.first.value < ends.last.value) != curve.wide ? ends.first : ends.last;
}
/// Time for which a point past an end stays there, with an acceleration of at most `acceleration`.
template <class R>
R stays_past(const Line<R>& line, const Motion<R>& m, const R& radius, const R& acceleration) {
    const Value<R> face = within(line, m, radius);
    return free_step(R(-face.value), R(-face.slope), acceleration);
}
/// On an arc of more than half a turn it is past both ends, and may come back by either.
template <class R>
R stays_past(const Curve<R>& curve, const Motion<R>& m, const R& radius, const R& acceleration) {
    const auto stays = [&](const Value<R>& end) {
        return free_step(R(-end.value), R(-end.slope), acceleration);
    };
    if (!curve.wide) return stays(within(curve, m, radius));
    const Ends<R> ends = within_ends(curve, m, radius);
    return std::min(stays(ends.first), stays(ends.last));
}

/// One side of a line: `sign` +1 on the left of it.
template <class R>
struct LineSide {
    const Line<R>& line;
    int sign;
    const R& radius;

    [[nodiscard]] Value<R> gap(const Motion<R>& m) const {
        return {sign * cross(line.along, m.position - line.start) - radius,
                sign * cross(line.along, m.velocity)};
    }
    /// Distance of the ball's centre from the surface; negative on the other side.
    [[nodiscard]] R off(const Motion<R>& m) const {
        return sign * cross(line.along, m.position - line.start);
    }
    [[nodiscard]] R bound(const View<R>& view, const Bounds<R>& bounds, const R& from, const R& until) const {
        return view.turning ? bounds.acceleration
                            : view.path.acceleration_bound_along(perp(line.along), from, until);
    }
    [[nodiscard]] Value<R> face(const Motion<R>& m) const { return within(line, m, radius); }
    [[nodiscard]] R stays_off(const Motion<R>& m, const R& acceleration) const {
        return stays_past(line, m, radius, acceleration);
    }
    [[nodiscard]] Polynomial<R> polynomial(const Motion<R>& m, const V<R>& a) const {
        const Value<R> g = gap(m);
        return {{g.value, g.slope, sign * cross(line.along, a) / 2, R(0), R(0)}};
    }
};

/// Outside (+1) or inside (−1) of a curve, as ±(|q|² − D²)/2D: smooth, and near the curve the distance.
template <class R>
struct CurveSide {
    const Curve<R>& curve;
    int sign;
    const R& radius;

    [[nodiscard]] R reach() const { return curve.radius + sign * radius; }
    [[nodiscard]] Value<R> gap(const Motion<R>& m) const {
        const V<R> out = m.position - curve.center;
        const R d = reach();
        if (curve.is_circle) {
            // The distance itself: it bends upwards but for the ball's acceleration.
            const R far = length(out);
            return {far - d, far > 0 ? R(dot(out, m.velocity) / far) : R(0)};
        }
        return {sign * (dot(out, out) - d * d) / (2 * d), sign * dot(out, m.velocity) / d};
    }
    /// Distance of the ball's centre from the surface; negative on the other side. A circle has no other
    /// side.
    [[nodiscard]] R off(const Motion<R>& m) const {
        const R far = length(V<R>(m.position - curve.center));
        return curve.is_circle ? far : R(sign * (far - curve.radius));
    }
    [[nodiscard]] R bound(const View<R>& view, const Bounds<R>& bounds, const R& from, const R& until) const {
        if (curve.is_circle) return bounds.acceleration;
        const R far = length(view.at(from).position - curve.center) + bounds.speed * (until - from);
        const R pulled = far * bounds.acceleration;
        return (sign > 0 ? pulled : R(bounds.speed * bounds.speed + pulled)) / reach();
    }
    /// As ±(|q|² − D²)/2D whatever the curve, on a flight with acceleration `a`.
    [[nodiscard]] SecondOrder<R> second_order(const Motion<R>& m, const V<R>& a) const {
        const V<R> out = m.position - curve.center;
        const R d = reach();
        return {sign * (dot(out, out) - d * d) / (2 * d), sign * dot(out, m.velocity) / d,
                sign * (dot(m.velocity, m.velocity) + dot(out, a)) / d};
    }
    /// Bound on its third derivative along a flight.
    [[nodiscard]] R jerk(const Path<R>& path, const Bounds<R>& bounds, const R& from, const R& until) const {
        const R far = length(path.at(from).position - curve.center) + bounds.speed * (until - from);
        return bounds.acceleration * (3 * bounds.speed + far * path.drag) / reach();
    }
    [[nodiscard]] Value<R> face(const Motion<R>& m) const { return within(curve, m, radius); }
    [[nodiscard]] R stays_off(const Motion<R>& m, const R& acceleration) const {
        return stays_past(curve, m, radius, acceleration);
    }
    [[nodiscard]] Polynomial<R> polynomial(const Motion<R>& m, const V<R>& a) const {
        const V<R> out = m.position - curve.center;
        const R d = reach(), f = sign / (2 * d);
        return {{f * (dot(out, out) - d * d), f * 2 * dot(out, m.velocity),
                 f * (dot(m.velocity, m.velocity) + dot(a, out)), f * dot(a, m.velocity), f * dot(a, a) / 4}};
    }
};

/// Calls visit(side) for each side that a ball of this radius can touch.
template <class R, class Visit>
void each_side(const Feature<R>& feature, const R& radius, Visit&& visit) {
    if (const auto* line = std::get_if<Line<R>>(&feature.is)) {
        visit(LineSide<R>{*line, 1, radius});
        visit(LineSide<R>{*line, -1, radius});
        return;
    }
    const auto& curve = std::get<Curve<R>>(feature.is);
    visit(CurveSide<R>{curve, 1, radius});
    if (!curve.is_circle && curve.radius > radius) visit(CurveSide<R>{curve, -1, radius});
}

}  // namespace flipside::reference

#include "reference/time_of_impact.hpp"

#include <algorithm>

#include "reference/polynomial.hpp"
#include "reference/sides.hpp"

namespace flipside::reference {

namespace {

/// An undamped flight from `m` on.
template <class R>
R polynomial_time_of_impact(const Feature<R>& feature, const Motion<R>& m, const V<R>& a, const R& radius,
                            const R& until, std::uint64_t& grazes) {
    R first = infinity<R>();
    bool close = false;
    const R slowest = rounding_speed(R(length(m.velocity) + length(a) * until));
    each_side(feature, radius, [&](const auto& side) {
        const FallingRoots<R> found = falling_roots(side.polynomial(m, a), until, slowest);
        close = close || found.grazes;
        for (int i = 0; i < found.count; ++i) {
            const R& t = found.at[static_cast<std::size_t>(i)];
            if (!(t < first)) break;
            const Motion<R> then{m.position + t * (m.velocity + (t / 2) * a), m.velocity + t * a};
            if (side.off(then) < 0 || side.face(then).value < 0) continue;
            first = t;
        }
    });
    using Wide = typename Wider<R>::type;
    if constexpr (!std::is_same_v<Wide, R>) {
        if (close) {
            ++grazes;
            return static_cast<R>(polynomial_time_of_impact<Wide>(
                widened<Wide>(feature), {V<Wide>(m.position), V<Wide>(m.velocity)}, V<Wide>(a), Wide(radius),
                Wide(until), grazes));
        }
    }
    return first;
}

}  // namespace

template <class R>
Closest<R> closest_point(const Feature<R>& feature, const V<R>& point, const R& radius) {
    const Motion<R> m{point, {}};
    if (const auto* line = std::get_if<Line<R>>(&feature.is)) {
        const R d = cross(line->along, point - line->start);
        const V<R> left = perp(line->along);
        return {magnitude(d) - radius, d >= 0 ? left : -left, within(*line, m, radius).value >= 0};
    }
    const auto& curve = std::get<Curve<R>>(feature.is);
    const V<R> out = point - curve.center;
    const R off = length(out) - curve.radius;
    const V<R> n = unit(out);
    const bool outside = curve.is_circle || off >= 0;
    return {(outside ? off : R(-off)) - radius, outside ? n : -n, within(curve, m, radius).value >= 0};
}

template <class R>
R time_of_impact(const Feature<R>& feature, const View<R>& view, const R& radius, const R& from,
                 const R& until, std::uint64_t& grazes) {
    if (!(until >= from)) return infinity<R>();
    const Path<R>& path = view.path;
    const bool still = view.turning == nullptr;
    if (still && path.rests) return infinity<R>();
    const Motion<R> begin = view.at(from);
    const Bounds<R> bounds = view.bounds(from, until);
    if (closest_point(feature, begin.position, radius).gap > bounds.speed * (until - from))
        return infinity<R>();
    if (still && !path.is_series && !(path.drag > 0))
        return from +
               polynomial_time_of_impact(feature, begin, path.acceleration, radius, R(until - from), grazes);

    R first = infinity<R>();
    each_side(feature, radius, [&](const auto& side) {
        const R bound = side.bound(view, bounds, from, until);
        const R last = first < until ? first : until;
        const Tolerance<R> tolerance{rounding_speed(bounds.speed), gap_rounding(begin.position, radius)};
        const auto accepts = [&](const R& t) {
            const Motion<R> m = view.at(t);
            return side.off(m) >= 0 && side.face(m).value >= 0;
        };
        const auto again = [&](const R& t) {
            const Motion<R> m = view.at(t);
            R step = 64 * epsilon<R>() * std::max(R(until - from), magnitude(t));
            if (side.face(m).value < 0) step = std::max(step, side.stays_off(m, bounds.acceleration));
            if (const R off = side.off(m); off < 0) step = std::max(step, R(off / -bounds.speed));
            return R(t + step);
        };
        bool grazing = false;
        R begins = from;
        if constexpr (requires { side.second_order(begin, path.acceleration); }) {
            const auto second_order = [&](const R& t) {
                const Motion<R> m = path.at(t);
                return side.second_order(m, path.acceleration - path.drag * m.velocity);
            };
            if (still && !path.is_series)
                begins = skip_flat_start(second_order, from, last, side.jerk(path, bounds, from, until),
                                         tolerance);
        }
        const R t = first_falling_root([&](const R& at) { return side.gap(view.at(at)); }, begins, last,
                                       bound, tolerance, accepts, again, grazing);
        grazes += grazing;
        if (t < first) first = t;
    });
    return first;
}

namespace {

/// Two points that move straight, x + u·e: the first e ≥ 0 at which they are `reach` apart and approach. A
/// gap up to `rounding` is contact, so that impacts of balls in contact are at one instant.
template <class R>
R straight_time_of_impact(const V<R>& x, const V<R>& u, const R& reach, const R& rounding,
                          std::uint64_t& grazes) {
    using std::sqrt;
    const R approach = dot(x, u), far = length(x), squared = dot(u, u);
    const R apart = (far - reach) * (far + reach);
    if (!(approach < 0)) return infinity<R>();
    if (far - reach <= rounding) return approach < -rounding_speed(R(length(u))) * far ? R(0) : infinity<R>();
    const R inside = approach * approach - squared * apart;
    if (magnitude(inside) <= 32 * epsilon<R>() * (approach * approach + squared * apart)) {
        using Wide = typename Wider<R>::type;
        if constexpr (!std::is_same_v<Wide, R>) {
            ++grazes;
            return static_cast<R>(
                straight_time_of_impact(V<Wide>(x), V<Wide>(u), Wide(reach), Wide(rounding), grazes));
        }
    }
    if (inside < 0) return infinity<R>();
    return apart / (sqrt(inside) - approach);
}

template <class R>
bool closed_form(const Path<R>& path) {
    return !path.is_series && !path.rests;
}

}  // namespace

template <class R>
R time_of_impact(const Path<R>& a, const Path<R>& b, const R& reach, const R& from, const R& until,
                 std::uint64_t& grazes) {
    using math::log1p;
    if (!(until >= from) || (a.rests && b.rests)) return infinity<R>();
    const Motion<R> one = a.at(from), other = b.at(from);
    const V<R> x = one.position - other.position, u = one.velocity - other.velocity;
    if (closed_form(a) && closed_form(b) && a.drag == b.drag && a.acceleration.x == b.acceleration.x &&
        a.acceleration.y == b.acceleration.y) {
        const R rounding = std::max(gap_rounding(one.position, reach), gap_rounding(other.position, reach));
        const R e = straight_time_of_impact(x, u, reach, rounding, grazes);
        if (!(a.drag > 0)) return from + e;
        return a.drag * e < 1 ? R(from - log1p(R(-a.drag * e)) / a.drag) : infinity<R>();
    }
    const Bounds<R> of_a = a.bounds(from, until), of_b = b.bounds(from, until);
    const R speed = of_a.speed + of_b.speed;
    if (length(x) - reach > speed * (until - from)) return infinity<R>();
    const auto gap = [&](const R& t) {
        const Motion<R> p = a.at(t), q = b.at(t);
        const V<R> between = p.position - q.position;
        const R far = length(between);
        return Value<R>{far - reach, dot(between, p.velocity - q.velocity) / far};
    };
    bool grazing = false;
    R t = first_falling_root(
        gap, from, until, R(of_a.acceleration + of_b.acceleration),
        Tolerance<R>{rounding_speed(speed), gap_rounding(one.position, reach)}, [](const R&) { return true; },
        [](const R& now) { return now; }, grazing);
    grazes += grazing;
    return t;
}

template <class R>
R leaves(const Path<R>& path, const Box& box, const R& from, const R& until, int& side) {
    R first = infinity<R>();
    if (path.rests) return first;
    const Bounds<R> bounds = path.bounds(from, until);
    const Vec2 begin = narrow(path.at(from).position);
    const double way = static_cast<double>(bounds.speed * (until - from)) * (1 + 1e-9);
    const R tiny = 16 * epsilon<R>() * (magnitude(R(begin.x)) + magnitude(R(begin.y)) + R(way));
    const auto offer = [&](double border, int sign, auto coordinate, int which) {
        if (!std::isfinite(border)) return;
        V<R> axis;
        axis.*coordinate = 1;
        const R at(border);
        const R last = first < until ? first : until;
        const R t = first_falling_root(
            [&](const R& time) {
                const Motion<R> m = path.at(time);
                return Value<R>{sign * (m.position.*coordinate - at), sign * (m.velocity.*coordinate)};
            },
            from, last, path.acceleration_bound_along(axis, from, until),
            Tolerance<R>{rounding_speed(bounds.speed), 16 * epsilon<R>() * magnitude(at) + tiny});
        if (t < first) first = t, side = which;
    };
    if (begin.x - box.min.x <= way) offer(box.min.x, 1, &V<R>::x, 0);
    if (box.max.x - begin.x <= way) offer(box.max.x, -1, &V<R>::x, 1);
    if (begin.y - box.min.y <= way) offer(box.min.y, 1, &V<R>::y, 2);
    if (box.max.y - begin.y <= way) offer(box.max.y, -1, &V<R>::y, 3);
    return first;
}

template <class R>
bool ends_in(const Feature<R>& face, const Feature<R>& circle, const V<R>& normal, const R& radius) {
    const auto* there = std::get_if<Curve<R>>(&circle.is);
    if (there == nullptr || !there->is_circle) return false;
    const auto touches = [&](const V<R>& end, const V<R>& n) {
        const V<R> center = end + radius * n;
        const R gap = length(center - there->center) - there->radius - radius;
        return magnitude(gap) <= 64 * epsilon<R>() * (length(center) + radius);
    };
    if (const auto* line = std::get_if<Line<R>>(&face.is)) {
        const R side(cross(line->along, normal) >= 0 ? 1 : -1);
        const V<R> n = side * perp(line->along);
        return touches(line->start, n) || touches(line->start + line->length * line->along, n);
    }
    const auto& curve = std::get<Curve<R>>(face.is);
    if (curve.full) return false;
    // The normal of a ball inside points to the center.
    for (const V<R>& end : {curve.from, curve.to})
        for (const int sign : {1, -1})
            if (touches(curve.center + curve.radius * end, R(sign) * end)) return true;
    return false;
}

template <class R>
bool lies_below(const Feature<R>& feature, const V<R>& at, const V<R>& normal) {
    const auto* curve = std::get_if<Curve<R>>(&feature.is);
    if (curve == nullptr) return false;
    const V<R> from_face = curve->center - at;
    const R size = length(curve->center) + length(from_face) + curve->radius;
    constexpr double rounding = 128 * 0x1p-53;  // scenes are in double, whatever R
    return dot(from_face, normal) + curve->radius <= rounding * size;
}

template <class R>
bool comes_off(const Feature<R>& face, const Motion<R>& motion, const R& radius) {
    const R rounding = 64 * epsilon<R>() * (length(motion.position) + radius);
    return std::visit(
        [&](const auto& shape) {
            const Value<R> inside = within(shape, motion, radius);
            return inside.slope < 0 && magnitude(inside.value) <= rounding;
        },
        face.is);
}

template <class R>
R leaves_face(const Feature<R>& feature, const View<R>& view, const R& radius, const R& from,
              const R& until) {
    if (!(until >= from)) return infinity<R>();
    const R bound = view.bounds(from, until).acceleration;
    const Tolerance<R> tolerance{rounding_speed(view.bounds(from, until).speed), 16 * epsilon<R>() * radius};
    return std::visit(
        [&](const auto& shape) {
            if constexpr (requires { shape.wide; }) {
                if (shape.full) return infinity<R>();
                if (shape.wide)
                    return first_falling_root([&](const R& t) { return within(shape, view.at(t), radius); },
                                              from, until, bound, tolerance);
            }
            // Each end separately, since the distance from the closer one is not smooth.
            const auto first = [&](const R& t) { return within_ends(shape, view.at(t), radius).first; };
            const auto last = [&](const R& t) { return within_ends(shape, view.at(t), radius).last; };
            return std::min(first_falling_root(first, from, until, bound, tolerance),
                            first_falling_root(last, from, until, bound, tolerance));
        },
        feature.is);
}

#define FLIPSIDE_TIME_OF_IMPACT(R)                                                                           \
    template Closest<R> closest_point(const Feature<R>&, const V<R>&, const R&);                             \
    template R time_of_impact(const Feature<R>&, const View<R>&, const R&, const R&, const R&,               \
                              std::uint64_t&);                                                               \
    template R time_of_impact(const Path<R>&, const Path<R>&, const R&, const R&, const R&, std::uint64_t&); \
    template R leaves(const Path<R>&, const Box&, const R&, const R&, int&);                                 \
    template bool ends_in(const Feature<R>&, const Feature<R>&, const V<R>&, const R&);                      \
    template bool lies_below(const Feature<R>&, const V<R>&, const V<R>&);                                   \
    template bool comes_off(const Feature<R>&, const Motion<R>&, const R&);                                  \
    template R leaves_face(const Feature<R>&, const View<R>&, const R&, const R&, const R&);
FLIPSIDE_TIME_OF_IMPACT(double)
FLIPSIDE_TIME_OF_IMPACT(Real113)
FLIPSIDE_TIME_OF_IMPACT(Real226)
#undef FLIPSIDE_TIME_OF_IMPACT

}  // namespace flipside::reference

#include "reference/region.hpp"

#include <algorithm>

namespace flipside::reference {

namespace {

template <class R>
using Regions = std::vector<Region<R>>;

/// Of conditions or regions that a search goes through one after another; a few, in practice.
constexpr int most_rounds = 10'000;

template <class R>
struct RegionBuilder {
    Regions<R>& regions;
    using Plane = typename Region<R>::Plane;
    using Polygon = typename Region<R>::Polygon;

    void disc(const V<R>& center, const R& radius) {
        regions.push_back({typename Region<R>::Disc{center, radius}});
    }
    /// The ball's reach around the line from a to b, on both sides.
    void slab(const V<R>& a, const V<R>& b) {
        const V<R> along = unit(b - a), n = perp(along);
        regions.push_back(
            {Polygon{{{n, a, R(0), 1}, {-n, a, R(0), 1}, {-along, a, R(0), 0}, {along, b, R(0), 0}}}});
    }
    void solid(const std::vector<V<R>>& corners) {
        Polygon inner;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const V<R>&a = corners[i], &b = corners[(i + 1) % corners.size()];
            inner.planes.push_back({-perp(unit(b - a)), a, R(0), 0});
            slab(a, b);
        }
        regions.push_back({std::move(inner)});
    }

    void operator()(const primitive::Point& p) { disc(V<R>(p.at), R(0)); }
    void operator()(const primitive::Circle& c) { disc(V<R>(c.center), R(c.radius)); }
    void operator()(const primitive::Segment& s) {
        slab(V<R>(s.a), V<R>(s.b));
        // Also where it has no ends to be hit, as a gate.
        disc(V<R>(s.a), R(0));
        disc(V<R>(s.b), R(0));
    }
    void operator()(const primitive::Arc& a) {
        const auto features = features_of<R>({Primitive{a, 0}}, one_part());
        Curve<R> first = std::get<Curve<R>>(features.front().is);
        if (first.wide) {
            // Beyond half a turn it is no common part of two half-planes.
            Curve<R> second = first;
            first.to = second.from = -first.from;
            regions.push_back({typename Region<R>::Band{second}});
        }
        regions.push_back({typename Region<R>::Band{first}});
    }
    void operator()(const primitive::Polygon& p) {
        std::vector<V<R>> corners;
        for (const Vec2 point : p.points) {
            corners.emplace_back(point);
            disc(V<R>(point), R(0));
        }
        solid(corners);
    }
    void operator()(const primitive::Taper& t) {
        disc(V<R>(t.a), R(t.radius_a));
        disc(V<R>(t.b), R(t.radius_b));
        std::vector<V<R>> ends;
        for (const Feature<R>& feature : features_of<R>({Primitive{t, 0}}, one_part()))
            if (const auto* line = std::get_if<Line<R>>(&feature.is)) {
                ends.push_back(line->start);
                ends.push_back(line->start + line->length * line->along);
            }
        // The first tangent lies to the left of the axis: anticlockwise is along the second, back on the
        // first.
        solid({ends[2], ends[3], ends[1], ends[0]});
    }

    static Scene one_part() {
        Scene scene;
        scene.parts.resize(1);
        return scene;
    }
};

/// What all searches of one ball in one part share.
template <class R>
struct Search {
    const View<R>& view;
    const R& radius;
    const R &from, &until;
    Bounds<R> bounds;
    R far, gap;  ///< m: bound on |q|; what counts as none

    Search(const View<R>& v, const R& r, const R& first, const R& last)
        : view(v), radius(r), from(first), until(last), bounds(v.bounds(first, last)) {
        far = length(v.at(from).position) + bounds.speed * (last - from);
        gap = 16 * epsilon<R>() * (far + r);
    }
    /// Bound on the acceleration along a unit vector. A ball that rolls along a face has none across it,
    /// however long it stays on the border of a sensor there.
    [[nodiscard]] R bound_along(const V<R>& n) const {
        if (view.turning != nullptr) return bounds.acceleration;
        return view.path.acceleration_bound_along(n, from, until) + epsilon<R>() * bounds.acceleration;
    }
    [[nodiscard]] Tolerance<R> tolerance() const { return {rounding_speed(bounds.speed), gap}; }

    /// Calls visit(condition, bound) for each condition of a region; a condition takes a Motion to a Value,
    /// whose second derivative is at most `bound` in size.
    void each_condition(const Region<R>& region, auto&& visit) const {
        const R squared = bounds.speed * bounds.speed, a = bounds.acceleration;
        if (const auto* polygon = std::get_if<typename Region<R>::Polygon>(&region.is)) {
            for (const auto& plane : polygon->planes)
                visit(
                    [&](const Motion<R>& m) {
                        return Value<R>{
                            plane.offset + plane.share * radius - dot(plane.n, m.position - plane.at),
                            -dot(plane.n, m.velocity)};
                    },
                    bound_along(plane.n));
            return;
        }
        const auto circle = [&](const V<R>& center, const R& d, int sign) {
            visit(
                [&center, d, sign](const Motion<R>& m) {
                    const V<R> out = m.position - center;
                    return Value<R>{sign * (d * d - dot(out, out)) / (2 * d),
                                    -sign * dot(out, m.velocity) / d};
                },
                R((squared + (far + length(center)) * a) / d));
        };
        if (const auto* disc = std::get_if<typename Region<R>::Disc>(&region.is)) {
            circle(disc->center, R(disc->radius + radius), 1);
            return;
        }
        const Curve<R>& arc = std::get<typename Region<R>::Band>(region.is).arc;
        circle(arc.center, R(arc.radius + radius), 1);
        if (arc.radius > radius) circle(arc.center, R(arc.radius - radius), -1);
        if (arc.full) return;
        visit(
            [&arc](const Motion<R>& m) {
                return Value<R>{cross(arc.from, m.position - arc.center), cross(arc.from, m.velocity)};
            },
            a);
        visit(
            [&arc](const Motion<R>& m) {
                return Value<R>{cross(m.position - arc.center, arc.to), cross(m.velocity, arc.to)};
            },
            a);
    }

    [[nodiscard]] bool holds(const Region<R>& region, const R& time) const {
        const Motion<R> now = view.at(time);
        bool all = true;
        each_condition(region,
                       [&](const auto& condition, const R&) { all = all && condition(now).value >= -gap; });
        return all;
    }
    /// First time from `time` on at which all conditions hold.
    [[nodiscard]] R begins(const Region<R>& region, R time) const {
        int rounds = 0;
        for (bool waits = true; waits && time <= until;) {
            if (++rounds > most_rounds) throw EndlessSearch();
            waits = false;
            const Motion<R> now = view.at(time);
            R next = time;
            each_condition(region, [&](const auto& condition, const R& bound) {
                if (condition(now).value >= -gap) return;
                waits = true;
                const auto lacks = [&](const R& t) {
                    const Value<R> v = condition(view.at(t));
                    return Value<R>{-v.value, -v.slope};
                };
                next = std::max(next, first_falling_root(lacks, time, until, bound, tolerance()));
            });
            if (waits && next <= time) return time;
            time = next;
        }
        return time <= until ? time : infinity<R>();
    }
    /// First time at which a condition fails.
    [[nodiscard]] R ends(const Region<R>& region, const R& time) const {
        R first = infinity<R>();
        each_condition(region, [&](const auto& condition, const R& bound) {
            const auto left = [&](const R& t) {
                const Value<R> v = condition(view.at(t));
                return Value<R>{v.value + 2 * gap, v.slope};
            };
            first = std::min(first, first_falling_root(left, time, until, bound, tolerance()));
        });
        return first;
    }
};

}  // namespace

template <class R>
std::vector<Region<R>> regions_of(const std::vector<Primitive>& primitives, PartIndex part) {
    Regions<R> regions;
    for (const Primitive& primitive : primitives)
        if (primitive.part == part) std::visit(RegionBuilder<R>{regions}, primitive.is);
    return regions;
}

template <class R>
bool inside(const Regions<R>& regions, const View<R>& view, const R& radius, const R& time) {
    const Search<R> search(view, radius, time, time);
    return std::ranges::any_of(regions, [&](const Region<R>& r) { return search.holds(r, time); });
}

template <class R>
R enters(const Regions<R>& regions, const View<R>& view, const R& radius, const R& from, const R& until) {
    R first = infinity<R>();
    for (const Region<R>& region : regions) {
        const R last = first < until ? first : until;
        const Search<R> search(view, radius, from, last);
        first = std::min(first, search.begins(region, from));
    }
    return first;
}

template <class R>
R leaves(const Regions<R>& regions, const View<R>& view, const R& radius, const R& from, const R& until) {
    const Search<R> search(view, radius, from, until);
    R time = from;
    int rounds = 0;
    for (bool in = true; in && time <= until;) {
        if (++rounds > most_rounds) throw EndlessSearch();
        in = false;
        for (const Region<R>& region : regions) {
            if (!search.holds(region, time)) continue;
            const R end = search.ends(region, time);
            if (end > time) {
                time = end;
                in = true;
                break;
            }
        }
    }
    return time <= until ? time : infinity<R>();
}

#define FLIPSIDE_REGIONS(R)                                                               \
    template std::vector<Region<R>> regions_of(const std::vector<Primitive>&, PartIndex); \
    template bool inside(const Regions<R>&, const View<R>&, const R&, const R&);          \
    template R enters(const Regions<R>&, const View<R>&, const R&, const R&, const R&);   \
    template R leaves(const Regions<R>&, const View<R>&, const R&, const R&, const R&);
FLIPSIDE_REGIONS(double)
FLIPSIDE_REGIONS(Real113)
FLIPSIDE_REGIONS(Real226)
#undef FLIPSIDE_REGIONS

}  // namespace flipside::reference

#include "reference/feature.hpp"

#include <algorithm>
#include <numbers>

#include "world/bounds.hpp"

namespace flipside::reference {

namespace {

template <class R>
struct End {
    V<R> at, outward;  ///< unit tangent, out of the curve
    PartIndex part;
};

/// Splits primitives into features.
template <class R>
class FeatureBuilder {
  public:
    FeatureBuilder(const std::vector<Primitive>& primitives, const Scene& scene) : scene_(scene) {
        for (const Primitive& primitive : primitives) {
            if (const auto* p = std::get_if<primitive::Point>(&primitive.is))
                points_.push_back({p->at, primitive.part});
            if (const auto* s = std::get_if<primitive::Segment>(&primitive.is))
                note_ends(line(s->a, s->b), primitive.part);
            if (const auto* a = std::get_if<primitive::Arc>(&primitive.is))
                note_ends(curve(*a), primitive.part);
        }
        const auto by_x = [](const auto& a, const auto& b) { return a.at.x < b.at.x; };
        std::stable_sort(points_.begin(), points_.end(), by_x);
        std::stable_sort(ends_.begin(), ends_.end(), by_x);
    }

    std::vector<Feature<R>> take(const std::vector<Primitive>& primitives) {
        for (const Primitive& primitive : primitives) {
            part_ = primitive.part;
            primitive_ = static_cast<std::uint32_t>(&primitive - primitives.data());
            if (!scene_.parts[part_].sensor) std::visit(*this, primitive.is);
        }
        return std::move(features_);
    }

    void operator()(const primitive::Point& p) { add(circle(V<R>(p.at), R(0))); }
    void operator()(const primitive::Circle& c) { add(circle(V<R>(c.center), R(c.radius))); }
    void operator()(const primitive::Segment& s) {
        Line<R> face = line(s.a, s.b);
        if (gate_of(scene_.parts[part_]) == nullptr) {
            face.before = reach({face.start, -face.along, part_});
            face.past = reach({face.start + face.length * face.along, face.along, part_});
        }
        add(face);
    }
    void operator()(const primitive::Arc& a) {
        Curve<R> arc = curve(a);
        if (!arc.full) {
            arc.before = reach({arc.center + arc.radius * arc.from, -perp(arc.from), part_});
            arc.past = reach({arc.center + arc.radius * arc.to, perp(arc.to), part_});
        }
        add(arc);
    }
    void operator()(const primitive::Polygon& p) {
        for (std::size_t i = 0; i < p.points.size(); ++i) {
            add(line(p.points[i], p.points[(i + 1) % p.points.size()]));
            add(circle(V<R>(p.points[i]), R(0)));
        }
    }
    void operator()(const primitive::Taper& t) {
        using std::sqrt;
        const V<R> a(t.a), b(t.b);
        add(circle(a, R(t.radius_a)));
        add(circle(b, R(t.radius_b)));
        // The outer tangents: their normals make the angle acos((r_a − r_b)/l) with the axis.
        const V<R> axis = b - a;
        const R l = length(axis), c = (R(t.radius_a) - R(t.radius_b)) / l, s = sqrt(1 - c * c);
        for (const int side : {1, -1}) {
            const V<R> normal = (c * axis + (side * s) * perp(axis)) / l;
            Line<R> face = line_between(a + R(t.radius_a) * normal, b + R(t.radius_b) * normal);
            face.before.joined = face.past.joined = true;
            add(face);
        }
    }

  private:
    void add(auto&& feature) { features_.push_back({feature, part_, primitive_}); }

    static Line<R> line_between(const V<R>& a, const V<R>& b) {
        return {a, unit(b - a), length(b - a), {}, {}};
    }
    static Line<R> line(Vec2 a, Vec2 b) { return line_between(V<R>(a), V<R>(b)); }
    static Curve<R> circle(const V<R>& center, const R& radius) {
        Curve<R> curve;
        curve.center = center;
        curve.radius = radius;
        curve.is_circle = curve.full = true;
        return curve;
    }
    static Curve<R> curve(const primitive::Arc& a) {
        Curve<R> curve;
        curve.center = V<R>(a.center);
        curve.radius = R(a.radius);
        curve.full = a.to - a.from >= 2 * std::numbers::pi;
        curve.wide = a.to - a.from > std::numbers::pi;
        curve.from = from_angle(R(a.from));
        curve.to = from_angle(R(a.to));
        return curve;
    }
    void note_ends(const Line<R>& l, PartIndex part) {
        ends_.push_back({l.start, -l.along, part});
        ends_.push_back({l.start + l.length * l.along, l.along, part});
    }
    void note_ends(const Curve<R>& c, PartIndex part) {
        ends_.push_back({c.center + c.radius * c.from, -perp(c.from), part});
        ends_.push_back({c.center + c.radius * c.to, perp(c.to), part});
    }

    /// Extension at an end, by the joints of its part and of others that can be hit.
    void each_at(const auto& sorted, const End<R>& end, auto&& visit) const {
        const R left = end.at.x - joint_distance, right = end.at.x + joint_distance;
        auto near = std::lower_bound(sorted.begin(), sorted.end(), left,
                                     [](const auto& one, const R& x) { return one.at.x < x; });
        for (; near != sorted.end() && !(near->at.x > right); ++near)
            if (length(V<R>(near->at) - end.at) <= joint_distance &&
                (near->part == end.part || always_stops(near->part)))
                visit(*near);
    }
    [[nodiscard]] bool always_stops(PartIndex part) const {
        return !scene_.parts[part].sensor && gate_of(scene_.parts[part]) == nullptr;
    }
    [[nodiscard]] Reach<R> reach(const End<R>& end) const {
        Reach<R> reach{true, R(0), R(0)};
        each_at(points_, end, [&](const auto&) { reach.joined = false; });
        if (!reach.joined) return reach;
        R least(3);
        each_at(ends_, end, [&](const End<R>& other) {
            const R kink = length(end.outward + other.outward);
            if (!(kink < least)) return;
            least = kink;
            reach.gap = length(end.at - other.at);
            reach.kink = kink;
        });
        return reach;
    }

    struct PointAt {
        Vec2 at;
        PartIndex part = 0;
    };
    const Scene& scene_;
    std::vector<PointAt> points_;
    std::vector<End<R>> ends_;
    std::vector<Feature<R>> features_;
    PartIndex part_ = 0;
    std::uint32_t primitive_ = 0;
};

}  // namespace

template <class R>
std::vector<Feature<R>> features_of(const std::vector<Primitive>& primitives, const Scene& scene) {
    return FeatureBuilder<R>(primitives, scene).take(primitives);
}

template <class R>
Feature<R> posed(const Feature<R>& feature, const V<R>& pivot, const V<R>& turn) {
    Feature<R> turned = feature;
    if (auto* line = std::get_if<Line<R>>(&turned.is)) {
        line->start = pivot + rotated(line->start - pivot, turn);
        line->along = rotated(line->along, turn);
    } else {
        auto& curve = std::get<Curve<R>>(turned.is);
        curve.center = pivot + rotated(curve.center - pivot, turn);
        curve.from = rotated(curve.from, turn);
        curve.to = rotated(curve.to, turn);
    }
    return turned;
}

template <class R>
Box bounds_of(const Feature<R>& feature) {
    if (const auto* line = std::get_if<Line<R>>(&feature.is)) {
        const Vec2 a = narrow(line->start), b = narrow(line->start + line->length * line->along);
        return united(bounds_of(a, 0), bounds_of(b, 0));
    }
    const auto& curve = std::get<Curve<R>>(feature.is);
    return bounds_of(narrow(curve.center), static_cast<double>(curve.radius));
}

#define FLIPSIDE_FEATURES(R)                                                                   \
    template std::vector<Feature<R>> features_of(const std::vector<Primitive>&, const Scene&); \
    template Feature<R> posed(const Feature<R>&, const V<R>&, const V<R>&);                    \
    template Box bounds_of(const Feature<R>&);
FLIPSIDE_FEATURES(double)
FLIPSIDE_FEATURES(Real113)
FLIPSIDE_FEATURES(Real226)
#undef FLIPSIDE_FEATURES

}  // namespace flipside::reference

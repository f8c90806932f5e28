#include "world/surface.hpp"

#include <algorithm>
#include <numbers>

namespace flipside {

namespace {

struct End {
    Vec2 at;
    Vec2 outward;  ///< unit tangent, out of the curve
    PartIndex part;
    bool smooth = false;
};

/// Collects the primitives and the ends of one part.
struct Taker {
    std::vector<Primitive>& primitives;
    std::vector<End>& ends;
    PartIndex part;

    void add(auto&& geometry) { primitives.push_back({std::forward<decltype(geometry)>(geometry), part}); }
    void segment(Vec2 a, Vec2 b) {
        add(primitive::Segment{a, b});
        const Vec2 along = unit(b - a);
        ends.push_back({a, -along, part});
        ends.push_back({b, along, part});
    }

    void operator()(const shape::Point& s) { add(primitive::Point{s.at}); }
    void operator()(const shape::Segment& s) { segment(s.a, s.b); }
    void operator()(const shape::Arc& s) {
        add(primitive::Arc{s.center, s.radius, s.from, s.to});
        if (s.to - s.from >= 2 * std::numbers::pi) return;
        const Vec2 first = from_angle(s.from), last = from_angle(s.to);
        ends.push_back({s.center + s.radius * first, -perp(first), part});
        ends.push_back({s.center + s.radius * last, perp(last), part});
    }
    void operator()(const shape::Circle& s) { add(primitive::Circle{s.center, s.radius}); }
    void operator()(const shape::Polygon& s) { add(primitive::Polygon{s.points}); }
    void operator()(const shape::Capsule& s) { add(primitive::Taper{s.a, s.b, s.radius, s.radius}); }
    void operator()(const shape::Flipper& s) {
        add(primitive::Taper{s.pivot, s.pivot + s.length * from_angle(s.rest), s.base_radius, s.tip_radius});
    }
    void operator()(const shape::Polyline& s) {
        for (std::size_t i = 1; i < s.points.size(); ++i) segment(s.points[i - 1], s.points[i]);
        if (s.closed) segment(s.points.back(), s.points.front());
    }
    void operator()(const shape::Gate& s) {
        add(primitive::Segment{s.a, s.b});
        add(primitive::Point{s.a});
        add(primitive::Point{s.b});
    }
    void operator()(const shape::Compound& s) {
        for (const Shape& member : s.of) std::visit(*this, member.is);
    }
};

bool may_join(const Part& a, const Part& b) {
    const auto plain = [](const Part& p) {
        return std::holds_alternative<motion::Still>(p.motion) && !p.sensor && !p.target;
    };
    return plain(a) && plain(b) && a.layer == b.layer && a.collides_with == b.collides_with;
}

bool joined(const End& a, const End& b, const Scene& scene) {
    return length(a.at - b.at) <= joint_distance &&
           (a.part == b.part || may_join(scene.parts[a.part], scene.parts[b.part]));
}

/// Adds one point primitive per joint or free end that can be hit.
void add_points(const Scene& scene, std::vector<End>& ends, std::vector<Primitive>& primitives) {
    std::stable_sort(ends.begin(), ends.end(), [](const End& a, const End& b) { return a.at.x < b.at.x; });
    const auto each_joined = [&](std::size_t i, auto&& visit) {
        for (std::size_t j = i + 1; j < ends.size() && ends[j].at.x - ends[i].at.x <= joint_distance; ++j)
            if (joined(ends[i], ends[j], scene)) visit(ends[j]);
    };
    for (std::size_t i = 0; i < ends.size(); ++i)
        each_joined(i, [&](End& other) {
            if (length(ends[i].outward + other.outward) <= joint_angle) ends[i].smooth = other.smooth = true;
        });
    // A third curve that ends on a smooth joint cannot be hit there either; and one corner is one point.
    std::vector<bool> done(ends.size());
    for (std::size_t i = 0; i < ends.size(); ++i) {
        bool smooth = ends[i].smooth;
        each_joined(i, [&](End& other) { smooth = smooth || other.smooth; });
        if (!done[i] && !smooth) primitives.push_back({primitive::Point{ends[i].at}, ends[i].part});
        each_joined(i, [&](End& other) {
            other.smooth = smooth;
            done[static_cast<std::size_t>(&other - ends.data())] = true;
        });
    }
}

}  // namespace

std::vector<Primitive> surface_of(const Scene& scene) {
    std::vector<Primitive> primitives;
    std::vector<End> ends;
    for (PartIndex i = 0; i < scene.parts.size(); ++i)
        std::visit(Taker{primitives, ends, i}, scene.parts[i].shape.is);
    add_points(scene, ends, primitives);
    std::stable_sort(primitives.begin(), primitives.end(),
                     [](const Primitive& a, const Primitive& b) { return a.part < b.part; });
    return primitives;
}

const shape::Gate* gate_of(const Part& part) {
    return std::get_if<shape::Gate>(&part.shape.is);
}

}  // namespace flipside

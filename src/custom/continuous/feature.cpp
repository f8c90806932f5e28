#include "custom/continuous/feature.hpp"

#include <algorithm>
#include <array>
#include <numbers>
#include <utility>

#include "world/bounds.hpp"

namespace flipside::custom {

namespace {

/// The end of a segment or arc.
struct End {
    Vec2 at, outward;  ///< unit tangent, out of the curve
};

std::array<End, 2> ends_of(const primitive::Segment& s) {
    const Vec2 along = unit(s.b - s.a);
    return {{{s.a, -along}, {s.b, along}}};
}
std::array<End, 2> ends_of(const primitive::Arc& a) {
    const Vec2 from = from_angle(a.from), to = from_angle(a.to);
    return {{{a.center + a.radius * from, -perp(from)}, {a.center + a.radius * to, perp(to)}}};
}

/// Visits the elements within joint_distance of `at`; `sorted` is sorted by x.
void each_at(const auto& sorted, Vec2 at, auto&& visit) {
    const auto x_of = [](const auto& p) { return p.at.x; };
    auto it = std::ranges::lower_bound(sorted, at.x - joint_distance, {}, x_of);
    for (; it != sorted.end() && it->at.x <= at.x + joint_distance; ++it)
        if (length(it->at - at) <= joint_distance) visit(*it);
}

/// Splits primitives into features. Finds the joints of segments and arcs: the ends with and without a point.
class FeatureBuilder {
  public:
    FeatureBuilder(std::span<const Primitive> primitives, const Scene& scene) : scene_(scene) {
        for (const Primitive& primitive : primitives) {
            // Sensors and gates do not always collide, so they form no joints.
            if (scene.parts[primitive.part].sensor || gate_of(scene.parts[primitive.part]) != nullptr)
                continue;
            if (const auto* point = std::get_if<primitive::Point>(&primitive.is)) points_.push_back(*point);
            const auto add_ends = [&](const auto* curve) {
                if (curve != nullptr) std::ranges::copy(ends_of(*curve), std::back_inserter(ends_));
            };
            add_ends(std::get_if<primitive::Segment>(&primitive.is));
            add_ends(std::get_if<primitive::Arc>(&primitive.is));
        }
        const auto x_of = [](const auto& p) { return p.at.x; };
        std::ranges::stable_sort(points_, {}, x_of);
        std::ranges::stable_sort(ends_, {}, x_of);
    }

    std::vector<Feature> build(std::span<const Primitive> primitives) {
        for (const Primitive& primitive : primitives) {
            primitive_ = static_cast<std::uint32_t>(&primitive - primitives.data());
            part_ = primitive.part;
            std::visit(*this, primitive.is);
        }
        return std::move(features_);
    }

    void operator()(const primitive::Point& p) { add(Circle{p.at, 0}); }
    void operator()(const primitive::Circle& c) { add(Circle{c.center, c.radius}); }
    void operator()(const primitive::Segment& s) {
        const auto [a, b] = ends_of(s);
        const bool gate = gate_of(scene_.parts[part_]) != nullptr;
        Line line = face(s.a, s.b);
        if (!gate) line.before = extension(a), line.past = extension(b);
        add(line);
    }
    void operator()(const primitive::Arc& a) {
        const double angle = a.to - a.from, half = std::min(angle / 2, std::numbers::pi);
        const auto [first, last] = ends_of(a);
        add(Arc{.center = a.center,
                .radius = a.radius,
                .from = from_angle(a.from),
                .to = from_angle(a.to),
                .middle = from_angle(a.from + half),
                .half_cosine = math::cos(half),
                .before = extension(first),
                .past = extension(last),
                .wide = angle > std::numbers::pi,
                .full = angle >= 2 * std::numbers::pi});
    }
    void operator()(const primitive::Polygon& p) {
        for (std::size_t i = 0; i < p.points.size(); ++i) {
            add(face(p.points[i], p.points[(i + 1) % p.points.size()]));
            add(Circle{p.points[i], 0});
        }
    }
    void operator()(const primitive::Taper& t) {
        add(Circle{t.a, t.radius_a});
        add(Circle{t.b, t.radius_b});
        // The outer tangents: their normals make the angle acos((r_a − r_b)/l) with the axis.
        const Vec2 axis = t.b - t.a;
        const double l = length(axis), c = (t.radius_a - t.radius_b) / l, s = std::sqrt(1 - c * c);
        for (const double side : {1.0, -1.0}) {
            const Vec2 normal = (c * axis + side * s * perp(axis)) / l;
            Line line = face(t.a + t.radius_a * normal, t.b + t.radius_b * normal);
            line.before = {true, 0, 0, rounding_at(line.start)};
            line.past = {true, 0, 0, rounding_at(t.b)};
            add(line);
        }
    }

  private:
    void add(auto&& feature) {
        const Part& part = scene_.parts[part_];
        features_.push_back({feature, primitive_, part_, part.layer, part.collides_with, part.sensor,
                             gate_of(part) != nullptr});
    }

    static Line face(Vec2 a, Vec2 b) { return {a, unit(b - a), length(b - a), {}, {}}; }

    static double rounding_at(Vec2 p) { return 64 * 0x1p-53 * (std::abs(p.x) + std::abs(p.y)); }

    [[nodiscard]] EndExtension extension(const End& end) const {
        EndExtension found{true, 0, 0, rounding_at(end.at)};
        each_at(points_, end.at, [&](const primitive::Point&) { found.joined = false; });
        if (!found.joined) return {};
        double least = 3;
        each_at(ends_, end.at, [&](const End& other) {
            const double kink = length(end.outward + other.outward);
            if (kink < least) {
                least = kink;
                found = {true, length(end.at - other.at), kink, rounding_at(end.at)};
            }
        });
        return found;
    }

    const Scene& scene_;
    std::vector<primitive::Point> points_;
    std::vector<End> ends_;
    std::vector<Feature> features_;
    std::uint32_t primitive_ = 0;
    PartIndex part_ = 0;
};

struct ClosestPointTo {
    Vec2 point;
    double radius = 0;

    Closest operator()(const Line& line) const {
        const Vec2 from_start = point - line.start;
        const double s = dot(from_start, line.along), d = cross(line.along, from_start);
        const bool facing = s >= -line.before.length(radius) && s <= line.length + line.past.length(radius);
        return {std::abs(d), d >= 0 ? perp(line.along) : -perp(line.along), facing};
    }
    Closest operator()(const Arc& arc) const {
        const Vec2 out = point - arc.center;
        const double d = length(out), off = d - arc.radius;
        const double past_from = cross(arc.from, out) + arc.before.length(radius);
        const double before_to = cross(out, arc.to) + arc.past.length(radius);
        const bool facing =
            arc.full || (arc.wide ? past_from >= 0 || before_to >= 0 : past_from >= 0 && before_to >= 0);
        const Vec2 n = unit(out);
        return {std::abs(off), off >= 0 ? n : -n, facing};
    }
    Closest operator()(const Circle& circle) const {
        const Vec2 out = point - circle.center;
        return {length(out) - circle.radius, unit(out), true};
    }
};

struct ClearOf {
    Vec2 a, b;
    double radius = 0, sag = 0;

    bool operator()(const Line& line) const {
        const Vec2 to_a = a - line.start, to_b = b - line.start;
        const double off_a = cross(line.along, to_a), off_b = cross(line.along, to_b), gap = radius + sag;
        if (std::min(off_a, off_b) > gap || std::max(off_a, off_b) < -gap) return true;
        const double s_a = dot(line.along, to_a), s_b = dot(line.along, to_b);
        return std::max(s_a, s_b) < -line.before.length(radius) - sag ||
               std::min(s_a, s_b) > line.length + line.past.length(radius) + sag;
    }
    bool operator()(const Arc& arc) const {
        if (beyond(arc.center, arc.radius + radius + sag)) return true;
        // The arc lies beyond the chord of its ends, except for its extensions.
        const double past = std::max(arc.before.length(radius), arc.past.length(radius)) + radius + sag;
        const double high = std::max(dot(arc.middle, a - arc.center), dot(arc.middle, b - arc.center));
        if (high < arc.radius * arc.half_cosine - past) return true;
        const double inner = arc.radius - radius - sag;
        return inner > 0 &&
               std::max(length_squared(a - arc.center), length_squared(b - arc.center)) < inner * inner;
    }
    bool operator()(const Circle& circle) const {
        return beyond(circle.center, circle.radius + radius + sag);
    }

  private:
    [[nodiscard]] bool beyond(Vec2 center, double reach) const {
        return distance_squared(center, a, b) > reach * reach;
    }
};

/// Bounds of a box that turns about a pivot.
Box turned_about(Vec2 pivot, const Box& box) {
    const double dx = std::max(box.max.x - pivot.x, pivot.x - box.min.x);
    const double dy = std::max(box.max.y - pivot.y, pivot.y - box.min.y);
    return bounds_of(pivot, std::sqrt(dx * dx + dy * dy));
}

}  // namespace

std::vector<Feature> features_of(std::span<const Primitive> primitives, const Scene& scene) {
    return FeatureBuilder(primitives, scene).build(primitives);
}

Closest closest_point(const Feature& feature, Vec2 point, double radius, const Pose& pose) {
    Closest found = std::visit(ClosestPointTo{pose.undo(point), radius}, feature.is);
    if (pose.angle != 0) found.normal = rotated(found.normal, pose.angle);
    return found;
}

bool clear_of(const Feature& feature, Vec2 a, Vec2 b, double radius, double sag) {
    return std::visit(ClearOf{a, b, radius, sag}, feature.is);
}

bool crosses(const Feature& feature, Vec2 a, Vec2 b) {
    const Vec2 way = b - a;
    if (const auto* line = std::get_if<Line>(&feature.is)) {
        const Vec2 from = a - line->start, left = perp(line->along);
        const double before = dot(from, left), after = dot(b - line->start, left);
        if ((before < 0) == (after < 0)) return false;
        const double at = dot(from, line->along) + before / (before - after) * dot(way, line->along);
        return at >= 0 && at <= line->length;
    }
    const auto* arc = std::get_if<Arc>(&feature.is);
    const auto [center, radius] = circle_of(feature);
    const Vec2 out = a - center;
    // |out + t way| = radius
    const double square = length_squared(way), half = dot(out, way);
    const double discriminant = half * half - square * (length_squared(out) - radius * radius);
    if (square == 0 || discriminant < 0) return false;
    const auto is_crossed_at = [&](double t) {
        return t >= 0 && t <= 1 &&
               (arc == nullptr || arc->full || dot(unit(out + t * way), arc->middle) >= arc->half_cosine);
    };
    const double root = std::sqrt(discriminant);
    return is_crossed_at((-half - root) / square) || is_crossed_at((root - half) / square);
}

bool continues_in(const Feature& face, Vec2 normal, const Feature& circle) {
    const auto* there = std::get_if<Circle>(&circle.is);
    if (there == nullptr) return false;
    // Whether the point of the circle with normal n is the end of the face.
    const auto goes_on = [&](Vec2 end, Vec2 n) {
        constexpr double rounding = 64 * 0x1p-53;
        const double size = std::abs(end.x) + std::abs(end.y) + there->radius;
        return length(there->center + there->radius * n - end) <= rounding * size;
    };
    if (const auto* line = std::get_if<Line>(&face.is)) {
        const Vec2 n = cross(line->along, normal) >= 0 ? perp(line->along) : -perp(line->along);
        return goes_on(line->start, n) || goes_on(line->start + line->length * line->along, n);
    }
    const auto* arc = std::get_if<Arc>(&face.is);
    if (arc == nullptr || arc->full) return false;
    return std::ranges::any_of(std::array{arc->from, arc->to}, [&](Vec2 end) {
        const Vec2 at = arc->center + arc->radius * end;
        return goes_on(at, end) || goes_on(at, -end);
    });
}

double distance_to_end(const Feature& feature, Vec2 point, Vec2 direction, double radius) {
    if (const auto* line = std::get_if<Line>(&feature.is)) {
        const double s = dot(point - line->start, line->along);
        return dot(direction, line->along) > 0 ? line->length - s : s;
    }
    const auto* arc = std::get_if<Arc>(&feature.is);
    if (arc == nullptr) return 1e-9 * radius;
    if (arc->full) return INFINITY;
    const Vec2 out = point - arc->center;
    const bool anticlockwise = cross(out, direction) > 0;
    const Vec2 a = anticlockwise ? out : arc->from, b = anticlockwise ? arc->to : out;
    const double angle = math::atan2(cross(a, b), dot(a, b));
    return arc->radius * (angle < -joint_angle ? angle + 2 * std::numbers::pi : angle);
}

std::vector<Box> ranges_of(std::span<const Feature> features, std::span<const Primitive> primitives,
                           const Table& table) {
    std::vector<Box> ranges;
    std::uint32_t before = ~0U;
    for (const Feature& feature : features) {
        Box box;
        if (feature.primitive != std::exchange(before, feature.primitive)) {
            box = bounds_of(primitives[feature.primitive]);
        } else if (const auto* line = std::get_if<Line>(&feature.is)) {
            box = united(bounds_of(line->start, 0), bounds_of(line->start + line->length * line->along, 0));
        } else {
            const auto [center, radius] = circle_of(feature);
            box = bounds_of(center, radius);
        }
        ranges.push_back(Table::moves(table.scene().parts[feature.part])
                             ? turned_about(table.pose(feature.part).pivot, box)
                             : box);
    }
    return ranges;
}

}  // namespace flipside::custom

#include "custom/trace/explain.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace flipside::custom {

namespace {

constexpr const char* to_a_point = "separation = |c - p| - r";
constexpr const char* to_a_circle = "separation = |c - m| - R - r";
constexpr const char* to_a_face = "separation = (c - p) · n - r";

/// "a = b - c m" with numbers for distance, core and radius.
std::string filled(double distance, double core, double radius) {
    const double separation = distance - core - radius;
    return brief(separation) + " = " + brief(distance) + (core > 0 ? " - " + brief(core) : "") + " - " +
           brief(radius) + " m";
}

/// The disc is in the frame of the pose; the values that are added are in the frame of the world.
struct Explainer {
    TraceItem& item;
    Vec2 center;
    double radius = 0;
    const Pose& pose;
    Touch found;

    /// `core`: the radius of a round feature.
    void add(const char* shape, std::string_view feature, const char* formula, double core = 0) const {
        item.with("shape", shape)
            .with("feature", feature)
            .with("formula", formula)
            .with("filled", filled(found.separation + radius + core, core, radius));
    }
    /// Adds the position of the closest point on a curve, from 0 to 1, before and after clamping.
    void add_position(double along) const {
        item.with("along", along).with("clamped", std::clamp(along, 0.0, 1.0));
    }
    void add_ends(Vec2 a, Vec2 b) const { item.with("a", pose.apply(a)).with("b", pose.apply(b)); }
    /// Adds a straight edge and the foot of the perpendicular. Returns the position of the foot, 0 at a, 1 at
    /// b.
    double add_edge(Vec2 a, Vec2 b) const {
        const double at = dot(center - a, b - a) / length_squared(b - a);
        add_ends(a, b);
        item.with("foot", pose.apply(a + at * (b - a)));
        add_position(at);
        return at;
    }

    void operator()(const primitive::Point&) const { add("point", "the point", to_a_point); }
    void operator()(const primitive::Circle& circle) const {
        add("circle", "the rim", to_a_circle, circle.radius);
    }
    void operator()(const primitive::Segment& segment) const {
        const double at = add_edge(segment.a, segment.b);
        const char* feature = at < 0 ? "past the end a" : at > 1 ? "past the end b" : "the face";
        add("segment", feature, found.past_end ? to_a_point : to_a_face);
    }
    void operator()(const primitive::Arc& arc) const {
        const auto end = [&](double angle) { return arc.center + arc.radius * from_angle(angle); };
        add_ends(end(arc.from), end(arc.to));
        item.with("middle", pose.apply(arc.center))
            .with("core", arc.radius)
            .with("from", arc.from + pose.angle)
            .with("to", arc.to + pose.angle);
        add_position(along(arc));
        const char* feature = found.past_end                             ? "past an end"
                              : length(center - arc.center) < arc.radius ? "the hollow side"
                                                                         : "the outer side";
        add("arc", feature, found.past_end ? to_a_point : "separation = ||c - m| - R| - r");
    }
    /// Position from one end of the arc, 0, to the other, 1; outside by the angle past the closer end.
    [[nodiscard]] double along(const primitive::Arc& arc) const {
        constexpr double full = 2 * std::numbers::pi;
        const double sweep = arc.to - arc.from;
        double angle = std::remainder(angle_of(center - arc.center) - (arc.from + arc.to) / 2, full);
        if (found.past_end) {
            const auto from_end = [&](double end) {
                return length_squared(found.point - arc.center - arc.radius * from_angle(end));
            };
            const bool at_first = from_end(arc.from) < from_end(arc.to);
            if (at_first != (angle < 0)) angle += at_first ? -full : full;
        }
        return angle / sweep + 0.5;
    }
    void operator()(const primitive::Polygon& polygon) const {
        const auto& points = polygon.points;
        std::vector<double> heights, outline;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const Vec2 next = points[(i + 1) % points.size()], in_world = pose.apply(points[i]);
            heights.push_back(dot(center - points[i], unit(-perp(next - points[i]))));
            outline.insert(outline.end(), {in_world.x, in_world.y});
        }
        const auto edge = static_cast<std::size_t>(std::ranges::max_element(heights) - heights.begin());
        const double at = add_edge(points[edge], points[(edge + 1) % points.size()]);
        const bool corner = heights[edge] > 0 && (at < 0 || at > 1);
        item.with("heights", TraceValue(std::move(heights))).with("outline", TraceValue(std::move(outline)));
        add("polygon", (corner ? "a corner of edge " : "edge ") + std::to_string(edge),
            corner ? to_a_point : to_a_face);
    }
    void operator()(const primitive::Taper& taper) const {
        const double span = length(taper.b - taper.a);
        const double slant = (taper.radius_a - taper.radius_b) / span;  // sine of the angle of the sides
        const Vec2 forward = (taper.b - taper.a) / span, from_a = center - taper.a;
        const bool round = std::abs(dot(found.normal, forward) - slant) > 1e-9;
        const bool at_a = length_squared(from_a) < length_squared(center - taper.b);
        add_ends(taper.a, taper.b);
        item.with("core", taper.radius_a).with("other_core", taper.radius_b);
        const double straight = std::sqrt((1 - slant) * (1 + slant));
        add_position((dot(from_a, forward) - slant * std::abs(dot(from_a, perp(forward))) / straight) / span);
        add(taper.radius_a == taper.radius_b ? "capsule" : "flipper",
            !round ? "a straight side"
            : at_a ? "the round end a"
                   : "the round end b",
            round ? to_a_circle : to_a_face,
            !round ? 0
            : at_a ? taper.radius_a
                   : taper.radius_b);
    }
};

}  // namespace

void explain_touch(TraceItem& item, Vec2 center, double radius, const Primitive& primitive,
                   const Pose& pose) {
    const Vec2 local = pose.undo(center);
    std::visit(Explainer{item, local, radius, pose, touch(local, radius, primitive, Pose{})}, primitive.is);
}

void explain_axes(TraceStage& stage, TraceItem about, Vec2 center, double radius,
                  const primitive::Polygon& polygon, const Pose& pose) {
    std::vector<Vec2> points;
    for (const Vec2 point : polygon.points) points.push_back(pose.apply(point));
    struct Axis {
        std::string of;
        Vec2 direction;
        std::vector<double> polygon, disc;  // projections
        [[nodiscard]] double overlap() const { return polygon[1] - disc[0]; }
    };
    std::vector<Axis> axes;
    const auto test_axis = [&](Vec2 axis, const std::string& of) {
        const auto along = [&](Vec2 p) { return dot(p, axis); };
        const auto [low, high] = std::ranges::minmax(points, {}, along);
        axes.push_back(
            {of, axis, {along(low), along(high)}, {along(center) - radius, along(center) + radius}});
    };
    std::size_t least = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vec2 next = points[(i + 1) % points.size()];
        test_axis(unit(-perp(next - points[i])), "edge " + std::to_string(i));
        if (axes[i].overlap() < axes[least].overlap()) least = i;
    }
    const Vec2 a = points[least], b = points[(least + 1) % points.size()];
    const bool outside = axes[least].overlap() < radius;
    const bool past_a = dot(center - a, b - a) < 0, past_b = dot(center - b, a - b) < 0;
    if (outside && (past_a || past_b)) {
        const std::size_t corner = past_a ? least : (least + 1) % points.size();
        test_axis(unit(center - points[corner]), "corner " + std::to_string(corner));
        least = points.size();
    }
    about.kind = "axis";
    for (const Axis& axis : axes)
        stage.items.emplace_back(about)
            .with("of", axis.of)
            .with("axis", axis.direction)
            .with("shadow_of_part", axis.polygon)
            .with("shadow_of_ball", axis.disc)
            .with("depth", axis.overlap())
            .with("decides", &axis == &axes[least])
            .with("formula", "overlap = end of the part's shadow - start of the ball's; below 0 a gap")
            .with("filled", filled(axis.polygon[1], 0, axis.disc[0]));
}

void explain_touch(TraceItem& item, Vec2 center_a, double radius_a, Vec2 center_b, double radius_b) {
    const Touch found = touch(center_a, radius_a, center_b, radius_b);
    Explainer{item, center_a, radius_a, {}, found}.add("ball", "the rim", to_a_circle, radius_b);
}

}  // namespace flipside::custom

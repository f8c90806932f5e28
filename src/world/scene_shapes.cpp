#include <numbers>

#include "world/scene_reader.hpp"
#include "world/surface.hpp"

// Shapes and motions: their numbers are in range by the schema, here they must also make sense together.

namespace flipside {

namespace {

/// Least length, m; closer ends would form one joint.
constexpr double shortest = joint_distance;
/// Sine of the least turn at a polygon's corner.
constexpr double least_turn = 1e-9;

bool same(Vec2 a, Vec2 b) {
    return length(b - a) <= shortest;
}

void check_apart(const Node& node, Vec2 a, Vec2 b) {
    if (same(a, b)) node.fail("a and b are the same point; allowed: at least 1e-6 m apart");
}

std::vector<Vec2> read_points(const Node& node, bool closed) {
    std::vector<Vec2> points;
    points.reserve(node.size());
    for (std::size_t i = 0; i < node.size(); ++i) {
        points.push_back(node.at(i).vector());
        if (i > 0 && same(points[i - 1], points[i]))
            node.at(i).fail("repeats the point before it; allowed: at least 1e-6 m apart");
    }
    if (closed && points.size() < 3)
        node.fail("a closed line of " + std::to_string(points.size()) + " points; allowed are 3 or more");
    if (closed && same(points.front(), points.back()))
        node.at(points.size() - 1)
            .fail("repeats the first point, to which a closed line returns by itself; leave it out");
    return points;
}

bool cross_each_other(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
    const auto side = [](Vec2 p, Vec2 q, Vec2 r) { return cross(q - p, r - p); };
    return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
}

bool crosses_itself(const std::vector<Vec2>& points) {
    const std::size_t n = points.size();
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = i + 2; j < n; ++j)
            if (cross_each_other(points[i], points[i + 1], points[j], points[(j + 1) % n])) return true;
    return false;
}

shape::Polygon read_polygon(const Node& shape) {
    const Node node = shape.at("points");
    std::vector<Vec2> points = read_points(node, true);
    const std::size_t n = points.size();
    double area = 0;  // twice, with sign
    for (std::size_t i = 0; i < n; ++i) area += cross(points[i] - points[0], points[(i + 1) % n] - points[0]);
    if (crosses_itself(points))
        node.fail("self-intersecting polygon: two sides cross; allowed are convex ones");
    double turned = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const Vec2 in = unit(points[i] - points[(i + n - 1) % n]);
        const Vec2 out = unit(points[(i + 1) % n] - points[i]);
        const double turn = area < 0 ? -cross(in, out) : cross(in, out);
        if (turn < -least_turn)
            node.at(i).fail(
                "concave polygon: it turns the other way at this corner; allowed are convex ones, others as "
                "a compound");
        if (turn <= least_turn)
            node.at(i).fail("degenerate polygon: this corner is on the line of its neighbours; leave it out");
        turned += math::atan2(turn, dot(in, out));
    }
    if (turned > 3 * std::numbers::pi)
        node.fail("self-intersecting polygon: it goes round more than once; allowed are convex ones");
    if (area < 0) std::reverse(points.begin(), points.end());
    return {std::move(points)};
}

shape::Arc read_arc(const Node& node) {
    const double from = node.real("from_deg"), to = node.real("to_deg");
    if (to <= from)
        node.fail("to_deg", "the arc runs anticlockwise; allowed: above from_deg, at most 360 above it");
    if (to - from > 360)
        node.fail("to_deg", "the arc is longer than its circle; allowed: at most 360 above from_deg");
    shape::Arc arc{node.vector("center"), node.real("radius"), node.radians("from_deg"),
                   node.radians("to_deg")};
    if (to - from == 360) arc.to = arc.from + 2 * std::numbers::pi;
    return arc;
}

shape::Flipper read_flipper(const Node& node) {
    const shape::Flipper flipper{node.vector("pivot"), node.real("length"), node.real("base_radius"),
                                 node.real("tip_radius"), node.radians("rest_deg")};
    if (flipper.length <= std::abs(flipper.base_radius - flipper.tip_radius) + shortest)
        node.fail(
            "length",
            "one of the flipper's circles contains the other; allowed: above the difference of the radii");
    return flipper;
}

shape::Gate read_gate(const Node& node) {
    const Vec2 a = node.vector("a"), b = node.vector("b"), normal = node.vector("normal");
    check_apart(node, a, b);
    if (length(normal) == 0)
        node.fail("normal", "is of length 0; allowed: any other direction across the gate");
    const Vec2 across = perp(unit(b - a));
    const double share = dot(unit(normal), across);
    if (std::abs(share) < 1e-6)
        node.fail("normal", "is parallel to the gate; allowed: a direction across it");
    return {a, b, share > 0 ? across : -across};
}

}  // namespace

Shape read_shape(const Node& node) {
    const std::string type = node.text("type");
    if (type == "point") return {shape::Point{node.vector("at")}};
    if (type == "arc") return {read_arc(node)};
    if (type == "circle") return {shape::Circle{node.vector("center"), node.real("radius")}};
    if (type == "polygon") return {read_polygon(node)};
    if (type == "flipper") return {read_flipper(node)};
    if (type == "gate") return {read_gate(node)};
    if (type == "polyline") {
        const bool closed = node.toggle("closed");
        return {shape::Polyline{read_points(node.at("points"), closed), closed}};
    }
    if (type == "compound") {
        shape::Compound compound;
        for (const Node& member : node.each("of")) {
            compound.of.push_back(read_shape(member));
            if (std::holds_alternative<shape::Gate>(compound.of.back().is))
                member.fail("a gate inside a compound; allowed is a gate as a part of its own");
        }
        return {std::move(compound)};
    }
    const Vec2 a = node.vector("a"), b = node.vector("b");
    check_apart(node, a, b);
    if (type == "segment") return {shape::Segment{a, b}};
    return {shape::Capsule{a, b, node.real("radius")}};
}

Motion read_motion(const Node& part, const Shape& shape) {
    if (!part.has("motion")) return motion::Still{};
    const Node node = part.at("motion");
    if (node.text("type") == "turn")
        return motion::Turn{node.vector("pivot"), node.real("rate"), node.toggle("always")};
    const auto* flipper = std::get_if<shape::Flipper>(&shape.is);
    if (flipper == nullptr) node.fail("type", "flip moves flippers only; allowed here: turn");
    const motion::Flip flip{node.text("side") == "left" ? Side::left : Side::right,
                            node.radians("raised_deg"), node.real("up_rate"), node.real("down_rate")};
    const double turn = std::abs(flip.raised - flipper->rest);
    if (turn == 0 || turn >= 2 * std::numbers::pi)
        node.fail("raised_deg", "the flipper turns by " +
                                    std::string(turn == 0 ? "nothing" : "a full circle") +
                                    "; allowed: other than rest_deg, less than 360 from it");
    return flip;
}

}  // namespace flipside

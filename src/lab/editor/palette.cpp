#include "lab/editor/palette.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace flipside::lab {

namespace {

constexpr std::string_view two = "Press at one end, let go at the other. Near another end it joins.";

constexpr Tool all_tools[] = {
    {"Select", 'S', "", 1,
     "Click a part, drag it or its handles; Shift picks several. Click the ground for the table itself."},
    {"Wall", 'W', "wall", 2, two},
    {"Walls", 'L', "walls", 0,
     "Click corner after corner; Enter or a double click ends, the first corner closes."},
    {"Arc", 'A', "arc", 2, "Press at one end, let go at the other; then pull its middle."},
    {"Circle", 'C', "circle", 2, "Press in the middle, let go at the rim."},
    {"Polygon", 'P', "polygon", 0,
     "Click the corners of a convex solid; Enter or the first corner closes it."},
    {"Capsule", 'K', "capsule", 2, "Press at one end, let go at the other; then pull its side."},
    {"Point", 'O', "point", 1, "Click where a pin of no width stands."},
    {"Flipper", 'F', "flipper", 2,
     "Press at the pivot, let go at the tip; the side follows from its direction."},
    {"Gate", 'G', "gate", 2,
     "Press at one end, let go at the other: the way through is to the left of the pull."},
    {"Lane", 'N', "lane", 2, "A sensor: press at one end, let go at the other. Balls pass over it."},
    {"Spot", 'T', "spot", 2, "A round sensor: press in the middle, let go at the rim."},
    {"Ball", 'B', "", 1, "Click where a ball is at the start; then pull at its arrow for a velocity."},
    {"Launcher", 'U', "", 1, "Click where balls enter: Space launches them. A scene has one."}};

double rounded_length(double value) {
    constexpr double per_metre = 1e6;
    return std::round(value * per_metre) / per_metre;
}

OrderedJson radius_json(double value) {
    return number(std::max(1e-4, rounded_length(value)));
}

double degrees_of(Vec2 way) {
    return std::round(angle_of(way) * 180 / std::numbers::pi * 1e6) / 1e6 + 0.0;
}

OrderedJson ends(const char* type, Vec2 a, Vec2 b) {
    return {{"type", type}, {"a", to_pair(a)}, {"b", to_pair(b)}};
}

OrderedJson round_shape(Vec2 center, Vec2 rim) {
    return {{"type", "circle"}, {"center", to_pair(center)}, {"radius", radius_json(length(rim - center))}};
}

/// A quarter, anticlockwise from a to b.
OrderedJson quarter(Vec2 a, Vec2 b) {
    const Vec2 center = 0.5 * (a + b + perp(b - a));
    const double from = degrees_of(a - center);
    const auto coordinate = [](double v) { return std::round(v * 1e9) / 1e9 + 0.0; };
    return {{"type", "arc"},
            {"center", to_pair({coordinate(center.x), coordinate(center.y)})},
            {"radius", number(std::round(length(a - center) * 1e9) / 1e9)},
            {"from_deg", number(from)},
            {"to_deg", number(from + 90)}};
}

OrderedJson corners(const char* type, std::span<const Vec2> points) {
    OrderedJson list = OrderedJson::array();
    for (const Vec2 point : points) list.push_back(to_pair(point));
    return {{"type", type}, {"points", list}};
}

OrderedJson flipper(Vec2 pivot, Vec2 tip, double ball) {
    return {{"type", "flipper"},
            {"pivot", to_pair(pivot)},
            {"length", radius_json(std::max(length(tip - pivot), 0.5 * ball))},
            {"base_radius", radius_json(0.75 * ball)},
            {"tip_radius", radius_json(0.45 * ball)},
            {"rest_deg", number(degrees_of(tip - pivot))}};
}

/// Raised by 50 degrees, upwards on the side to which it points.
OrderedJson flip(Vec2 way) {
    const bool left = way.x >= 0;
    const double rest = degrees_of(way);
    return {{"type", "flip"},
            {"side", left ? "left" : "right"},
            {"raised_deg", number(left ? rest + 50 : rest - 50)},
            {"up_rate", 40},
            {"down_rate", 20}};
}

OrderedJson shape_by(const Tool& tool, std::span<const Vec2> points, Vec2 last, double ball) {
    const Vec2 first = points.front();
    if (tool.name == "Point") return {{"type", "point"}, {"at", to_pair(first)}};
    if (tool.name == "Walls") return corners("polyline", points);
    if (tool.name == "Polygon") return corners("polygon", points);
    if (tool.name == "Circle" || tool.name == "Spot") return round_shape(first, last);
    if (tool.name == "Arc") return quarter(first, last);
    if (tool.name == "Flipper") return flipper(first, last, ball);
    OrderedJson shape = ends(tool.name == "Capsule" ? "capsule"
                             : tool.name == "Gate"  ? "gate"
                                                    : "segment",
                             first, last);
    if (tool.name == "Capsule") shape["radius"] = radius_json(0.5 * ball);
    if (tool.name == "Gate") {
        const Vec2 across = perp(unit(last - first));
        shape["normal"] = to_pair({rounded_length(across.x), rounded_length(across.y)});
    }
    return shape;
}

OrderedJson ball_kind(double radius) {
    constexpr double steel = 8000;  // kg/m³: 80 g at a radius of 13.4 mm
    const double mass = steel * 4 / 3 * std::numbers::pi * radius * radius * radius;
    const double digits = std::pow(10, 2 - std::floor(std::log10(mass)));
    return {{"radius", number(radius)}, {"mass", number(std::round(mass * digits) / digits)}};
}

}  // namespace

std::span<const Tool> tools() {
    return all_tools;
}

std::string_view place_of(const Tool& tool) {
    return tool.name == "Ball" ? "balls" : tool.name == "Launcher" ? "launcher" : "parts";
}

OrderedJson made(const Tool& tool, std::span<const Vec2> points, const std::string& name,
                 double ball_radius) {
    const Vec2 first = points.front();
    if (tool.name == "Ball") {
        OrderedJson ball{{"position", to_pair(first)}};
        ball.update(ball_kind(ball_radius));
        return ball;
    }
    if (tool.name == "Launcher")
        return {{"position", to_pair(first)},
                {"direction_deg", 90},
                {"speed", {0.5, 3}},
                {"plunger", true},
                {"ball", ball_kind(ball_radius)}};
    Vec2 last = points.back();
    if (tool.points == 2 && length(last - first) < 1e-4) last = first + Vec2{4 * ball_radius, 0};
    OrderedJson part{{"name", name}, {"shape", shape_by(tool, points, last, ball_radius)}};
    if (tool.name == "Flipper") part["motion"] = flip(last - first);
    if (tool.name == "Lane" || tool.name == "Spot") part["sensor"] = true;
    return part;
}

std::string new_scene() {
    return R"({
  "format": "flipside-scene/1",
  "name": "new table",
  "about": "A table drawn by hand.",
  "bounds": {"min": [0, 0], "max": [0.52, 1.07]},
  "gravity": [0, -1.11],
  "rest_speed": 0.02,
  "materials": {
    "ball": {"restitution": 0.95, "friction": 0.1},
    "wall": {"restitution": 0.6},
    "rubber": {"restitution": 0.75, "friction": 0.4},
    "bumper": {"restitution": 0.8, "kick": 1.6}
  },
  "balls": [],
  "parts": []
}
)";
}

}  // namespace flipside::lab

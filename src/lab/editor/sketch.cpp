#include "lab/editor/sketch.hpp"

#include <algorithm>
#include <numbers>

namespace flipside::lab {

namespace {

double radians(const OrderedJson& json, const char* key) {
    return json.at(key).get<double>() * std::numbers::pi / 180;
}

std::vector<Vec2> points_of(const OrderedJson& json) {
    std::vector<Vec2> points;
    for (const OrderedJson& pair : json) points.push_back(vector_of(pair));
    return points;
}

shape::Arc arc_of(const OrderedJson& json) {
    const double from = radians(json, "from_deg"), to = radians(json, "to_deg");
    constexpr double turn = 2 * std::numbers::pi;
    return {vector_of(json.at("center")), json.at("radius"), from, std::clamp(to, from + 1e-3, from + turn)};
}

/// Anticlockwise, as far as it goes round at all.
shape::Polygon polygon_of(const OrderedJson& json) {
    std::vector<Vec2> points = points_of(json.at("points"));
    double area = 0;  // twice, with sign
    for (std::size_t i = 0; i < points.size(); ++i)
        area += cross(points[i] - points[0], points[(i + 1) % points.size()] - points[0]);
    if (area < 0) std::ranges::reverse(points);
    return {std::move(points)};
}

Motion motion_of(const OrderedJson& part) {
    if (!part.contains("motion")) return motion::Still{};
    const OrderedJson& json = part.at("motion");
    if (json.at("type") == "turn")
        return motion::Turn{vector_of(json.at("pivot")), json.at("rate"), json.value("always", false)};
    return motion::Flip{json.at("side") == "left" ? Side::left : Side::right, radians(json, "raised_deg"),
                        json.at("up_rate"), json.at("down_rate")};
}

std::uint32_t material_of(const Scene& scene, const OrderedJson& thing) {
    const auto found = std::ranges::find(scene.materials, thing.value("material", ""), &Material::name);
    return found == scene.materials.end() ? 0 : static_cast<std::uint32_t>(found - scene.materials.begin());
}

Part part_of(const Scene& scene, const OrderedJson& json) {
    Part part;
    part.name = json.at("name");
    part.material = material_of(scene, json);
    part.shape = sketch_of_shape(json.at("shape"));
    part.motion = motion_of(json);
    part.sensor = json.value("sensor", false);
    part.target = json.value("target", false);
    return part;
}

Ball ball_of(const Scene& scene, const OrderedJson& json) {
    Ball ball;
    ball.number = static_cast<BallNumber>(scene.balls.size());
    ball.position = vector_of(json.at("position"));
    if (json.contains("velocity")) ball.velocity = vector_of(json.at("velocity"));
    ball.radius = json.at("radius");
    ball.mass = json.at("mass");
    ball.material = material_of(scene, json);
    return ball;
}

}  // namespace

Vec2 vector_of(const OrderedJson& pair) {
    return {pair.at(0).get<double>(), pair.at(1).get<double>()};
}

OrderedJson to_pair(Vec2 v) {
    return OrderedJson::array({number(v.x), number(v.y)});
}

Shape sketch_of_shape(const OrderedJson& json) {
    const std::string type = json.at("type");
    if (type == "point") return {shape::Point{vector_of(json.at("at"))}};
    if (type == "arc") return {arc_of(json)};
    if (type == "circle") return {shape::Circle{vector_of(json.at("center")), json.at("radius")}};
    if (type == "polygon") return {polygon_of(json)};
    if (type == "polyline")
        return {shape::Polyline{points_of(json.at("points")), json.value("closed", false)}};
    if (type == "flipper")
        return {shape::Flipper{vector_of(json.at("pivot")), json.at("length"), json.at("base_radius"),
                               json.at("tip_radius"), radians(json, "rest_deg")}};
    if (type == "compound") {
        shape::Compound compound;
        for (const OrderedJson& member : json.at("of")) compound.of.push_back(sketch_of_shape(member));
        return {std::move(compound)};
    }
    const Vec2 a = vector_of(json.at("a")), b = vector_of(json.at("b"));
    if (type == "segment") return {shape::Segment{a, b}};
    if (type == "capsule") return {shape::Capsule{a, b, json.at("radius")}};
    const Vec2 across = perp(unit(b - a));
    return {shape::Gate{a, b, dot(vector_of(json.at("normal")), across) < 0 ? -across : across}};
}

Scene sketch_of(const OrderedJson& document) {
    Scene scene;
    scene.name = document.value("name", "");
    scene.materials = {Material{}};
    const OrderedJson materials = document.value("materials", OrderedJson::object());
    for (const auto& [name, json] : materials.items())
        scene.materials.push_back(
            {name, json.value("restitution", 1.0), json.value("friction", 0.0), json.value("kick", 0.0)});
    for (const OrderedJson& part : document.value("parts", OrderedJson::array()))
        scene.parts.push_back(part_of(scene, part));
    for (const OrderedJson& ball : document.value("balls", OrderedJson::array()))
        scene.balls.push_back(ball_of(scene, ball));
    if (document.contains("bounds"))
        scene.bounds = {vector_of(document.at("bounds").at("min")),
                        vector_of(document.at("bounds").at("max"))};
    if (document.contains("launcher")) {
        const OrderedJson& json = document.at("launcher");
        Launcher launcher;
        launcher.position = vector_of(json.at("position"));
        launcher.direction = from_angle(radians(json, "direction_deg"));
        launcher.ball.radius = json.at("ball").at("radius");
        scene.launcher = launcher;
    }
    return scene;
}

}  // namespace flipside::lab

#include "world/ball_json.hpp"

#include <bit>

namespace flipside {

namespace {

Json json_pair(Vec2 v) {
    return {v.x, v.y};
}

std::uint32_t read_material(const Node& node, const SceneNames& names) {
    if (!node.has("material")) return 0;
    const std::string name = node.text("material");
    const auto found = names.material(name);
    if (!found)
        node.fail("material",
                  in_quotes(name) + " is no material of this scene; allowed: " +
                      names_of(names.scene().materials, [](const Material& m) { return m.name; }));
    return *found;
}

}  // namespace

Json to_json(const Ball& ball, const Scene& scene) {
    Json json = {{"number", ball.number},
                 {"position", json_pair(ball.position)},
                 {"velocity", json_pair(ball.velocity)},
                 {"angle", ball.angle},
                 {"spin", ball.spin},
                 {"radius", ball.radius},
                 {"mass", ball.mass},
                 {"layer", ball.layer},
                 {"collides_with", ball.collides_with},
                 {"asleep", ball.asleep}};
    if (ball.material != 0) json["material"] = scene.materials[ball.material].name;
    return json;
}

Ball read_ball(const Node& node, const SceneNames& names) {
    Ball ball;
    ball.number = static_cast<BallNumber>(node.integer("number"));
    ball.position = node.vector("position");
    ball.velocity = node.vector("velocity");
    ball.angle = node.real("angle", 0);
    ball.spin = node.real("spin", 0);
    ball.radius = node.real("radius");
    ball.mass = node.real("mass");
    ball.material = read_material(node, names);
    ball.layer = static_cast<std::uint32_t>(node.integer("layer", ball.layer));
    ball.collides_with = static_cast<std::uint32_t>(node.integer("collides_with", ball.collides_with));
    ball.asleep = node.toggle("asleep");
    if (!std::has_single_bit(ball.layer)) node.fail("layer", "is not one bit; allowed: a power of two");
    return ball;
}

}  // namespace flipside

#pragma once
/// Small scenes made in code, and worlds of them.

#include <memory>
#include <string>

#include "custom/engine.hpp"

namespace flipside::custom::test {

inline Scene empty_scene(Vec2 gravity = {}) {
    Scene scene;
    scene.name = "test";
    scene.bounds = {{-100, -100}, {100, 100}};
    scene.gravity = gravity;
    scene.materials = {{"default", 1, 0, 0}};
    return scene;
}

inline Ball& add_ball(Scene& scene, Vec2 position, Vec2 velocity = {}, double radius = 0.1, double mass = 1) {
    Ball ball;
    ball.number = static_cast<BallNumber>(scene.balls.size());
    ball.position = position;
    ball.velocity = velocity;
    ball.radius = radius;
    ball.mass = mass;
    return scene.balls.emplace_back(ball);
}

/// Adds a part with a material of its own.
inline Part& add_part(Scene& scene, const Shape& shape, Material material = {}) {
    material.name = "material " + std::to_string(scene.materials.size());
    Part part;
    part.name = "part " + std::to_string(scene.parts.size());
    part.material = static_cast<std::uint32_t>(scene.materials.size());
    part.shape = shape;
    scene.materials.push_back(material);
    return scene.parts.emplace_back(part);
}

inline Shape segment(Vec2 a, Vec2 b) {
    return {shape::Segment{a, b}};
}

/// On the discrete solver unless the settings say otherwise.
inline std::unique_ptr<World> make_world(
    const Scene& scene, std::initializer_list<std::pair<std::string_view, std::string_view>> settings = {}) {
    Settings values(engine().settings);
    values.set("solver", "discrete");
    for (const auto& [name, value] : settings) values.set(name, value);
    return engine().make(std::make_shared<const Scene>(scene), values);
}

inline void run(World& world, double seconds, double dt = 1.0 / 60) {
    const auto steps = static_cast<int>(std::lround(seconds / dt));
    for (int i = 0; i < steps; ++i) world.step(dt);
}

}  // namespace flipside::custom::test

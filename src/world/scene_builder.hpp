#pragma once
/// Small scenes made in code: for experiments and tests that need no file.

#include <string>

#include "world/scene.hpp"

namespace flipside {

/// No parts, no balls; 200 m × 200 m about the origin; material 0 is elastic and smooth.
inline Scene empty_scene(Vec2 gravity = {}) {
    Scene scene;
    scene.name = "empty";
    scene.bounds = {{-100, -100}, {100, 100}};
    scene.gravity = gravity;
    scene.materials = {{"default", 1, 0, 0}};
    scene.layers = {"default"};
    return scene;
}

/// Adds a ball of material 0.
inline Ball& add_ball(Scene& scene, Vec2 position, Vec2 velocity = {}, double radius = 0.1, double mass = 1) {
    Ball ball;
    ball.number = static_cast<BallNumber>(scene.balls.size());
    ball.position = position;
    ball.velocity = velocity;
    ball.radius = radius;
    ball.mass = mass;
    return scene.balls.emplace_back(ball);
}

/// Adds a part with a material of its own, whose name is made up.
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

}  // namespace flipside

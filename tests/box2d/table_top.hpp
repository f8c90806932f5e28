#pragma once
/// Small scenes for the tests of this folder, and what they ask of a world.

#include <memory>
#include <string>

#include "box2d/engine.hpp"

namespace flipside::box2d::test {

inline constexpr double radius = 0.0135;  // m, of a pinball

/// A scene of 4 m × 4 m about the origin, with Earth's gravity, that parts and balls are put into.
struct TableTop {
    Scene scene;

    TableTop() {
        scene.bounds = {{-2, -2}, {2, 2}};
        scene.gravity = {0, -9.81};
        scene.materials = {{"default", 1, 0, 0}};
        scene.layers = {"default"};
    }
    std::uint32_t material(double restitution, double friction = 0, double kick = 0) {
        const auto index = static_cast<std::uint32_t>(scene.materials.size());
        scene.materials.push_back({std::to_string(index), restitution, friction, kick});
        return index;
    }
    Part& part(auto&& shape, std::uint32_t with_material = 0) {
        Part part;
        part.name = std::to_string(scene.parts.size());
        part.material = with_material;
        part.shape.is = std::forward<decltype(shape)>(shape);
        return scene.parts.emplace_back(std::move(part));
    }
    /// A pinball.
    Ball& ball(Vec2 position, Vec2 velocity = {}, std::uint32_t with_material = 0) {
        Ball ball;
        ball.number = static_cast<BallNumber>(scene.balls.size());
        ball.position = position;
        ball.velocity = velocity;
        ball.radius = radius;
        ball.mass = 0.08;
        ball.material = with_material;
        return scene.balls.emplace_back(ball);
    }
    [[nodiscard]] std::unique_ptr<World> world(const Settings& settings = Settings(engine().settings)) const {
        return engine().make(std::make_shared<Scene>(scene), settings);
    }
};

inline constexpr double frame = 1.0 / 60;

/// Steps a world for `seconds` and shows each step to `see`.
inline void run(World& world, double seconds, auto&& see) {
    const auto steps = static_cast<int>(std::lround(seconds / frame));
    for (int i = 0; i < steps; ++i) {
        world.step(frame);
        see();
    }
}
inline void run(World& world, double seconds) {
    run(world, seconds, [] {});
}

inline int count(std::span<const Event> events, EventKind kind) {
    int n = 0;
    for (const Event& event : events) n += event.kind == kind;
    return n;
}

}  // namespace flipside::box2d::test

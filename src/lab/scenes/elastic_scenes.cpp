#include "lab/scenes/elastic_scenes.hpp"

#include <cmath>
#include <numbers>

namespace flipside::lab {

Scene elastic_gas(int balls) {
    constexpr double radius = 0.1, covered = 0.2;
    const double side = std::sqrt(balls * std::numbers::pi * radius * radius / covered);
    const int columns = static_cast<int>(std::ceil(std::sqrt(balls)));
    Scene scene;
    scene.name = "gas";
    scene.bounds = {{-1, -1}, {side + 1, side + 1}};
    scene.rest_speed = 0;
    scene.materials = {{"elastic", 1, 0, 0}};
    scene.layers = {"default"};
    for (int i = 0; i < balls; ++i) {
        Ball ball;
        ball.number = static_cast<BallNumber>(i);
        const int column = i % columns, row = i / columns;
        ball.position = side / columns * Vec2{column + 0.5, row + 0.5};
        ball.velocity = (0.5 + (i * 7 % 10) / 10.0) * from_angle(2.4 * i);
        ball.radius = radius;
        ball.mass = 1;
        scene.balls.push_back(ball);
    }
    Part walls;
    walls.name = "walls";
    walls.shape = {shape::Polyline{{{0, 0}, {side, 0}, {side, side}, {0, side}}, true}};
    scene.parts.push_back(walls);
    return scene;
}

Scene elastic_drop() {
    Scene scene;
    scene.name = "elastic drop";
    scene.bounds = {{-1, -1}, {1, 2}};
    scene.gravity = {0, -9.81};
    scene.materials = {{"elastic", 1, 0, 0}};
    scene.layers = {"default"};
    Ball ball;
    ball.radius = 0.0135;
    ball.mass = 0.08;
    ball.position = {0, 1 + ball.radius};
    scene.balls.push_back(ball);
    Part floor;
    floor.name = "floor";
    floor.shape = {shape::Segment{{-0.8, 0}, {0.8, 0}}};
    scene.parts.push_back(floor);
    return scene;
}

}  // namespace flipside::lab

#include "lab/hunt/random_scene.hpp"

namespace flipside::lab {

Scene RandomScene::make() {
    Scene scene = empty_scene(pick({Vec2{}, Vec2{0, -9.81}, 4 * direction()}));
    scene.bounds = {{-1.2, -1.2}, {1.2, 1.2}};
    scene.damping = pick({0.0, 0.0, 0.3});
    scene.rest_speed = pick({0.01, 0.1});
    scene.materials[0] = material();
    add_part(scene, {shape::Polyline{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}, true}}, material());
    const int parts = whole(1, 5), balls = whole(1, 6);
    for (int i = 0; i < parts; ++i) add_part_to(scene);
    for (int i = 0; i < balls; ++i) add_ball_to(scene);
    return scene;
}

/// One draw after the other: the order in which arguments and operands are evaluated differs between
/// compilers.
Vec2 RandomScene::vector(double shortest, double longest) {
    const Vec2 along = direction();
    return real(shortest, longest) * along;
}

void RandomScene::add_ball_to(Scene& scene) {
    const double radius = real(0.03, 0.1);
    const double mass = pick({0.1, 1.0, 1.0, 30.0});
    const Vec2 velocity = vector(0, 4), position{real(-0.85, 0.85), real(-0.85, 0.85)};
    add_ball(scene, position, velocity, radius, mass);
    scene.balls.back().spin = pick({0.0, real(-20, 20)});
}

Material RandomScene::material() {
    return {"", pick({0.0, 0.5, 0.9, 1.0}), pick({0.0, 0.0, 0.2, 0.6}), pick({0.0, 0.0, 0.0, 1.5})};
}

Shape RandomScene::shape() {
    const Vec2 at = place(), to = at + vector(0.1, 0.5);
    switch (whole(0, 6)) {
        case 0:
            return {shape::Point{at}};
        case 1: {
            const double from = real(-3, 3);
            return {shape::Arc{at, real(0.15, 0.5), from, from + real(0.5, 6)}};
        }
        case 2:
            return {shape::Circle{at, real(0.03, 0.2)}};
        case 3: {
            const Vec2 x = vector(0.05, 0.2), y = real(0.5, 1.5) * perp(x);
            return {shape::Polygon{{at - x - y, at + x - y, at + 0.7 * x + y, at - x + y}}};
        }
        case 4:
            return {shape::Capsule{at, to, real(0.01, 0.08)}};
        case 5:
            return {shape::Polyline{{at, to, to + vector(0.1, 0.4)}, false}};
        default:
            return segment(at, to);
    }
}

void RandomScene::add_part_to(Scene& scene) {
    switch (whole(0, 5)) {
        case 0: {
            const Vec2 pivot = place();
            const double rest = real(-3, 3);
            const motion::Flip flip{Side::left, rest + real(0.3, 1.2), real(5, 30), real(5, 15)};
            const Material rubber = material();
            add_part(scene, {shape::Flipper{pivot, real(0.2, 0.4), 0.05, 0.03, rest}}, rubber).motion = flip;
            return;
        }
        case 1: {
            const Shape turning = shape();
            const motion::Turn turn{place(), real(-6, 6), true};
            add_part(scene, turning, material()).motion = turn;
            return;
        }
        default: {
            const Shape still = shape();
            add_part(scene, still, material());
        }
    }
}

}  // namespace flipside::lab

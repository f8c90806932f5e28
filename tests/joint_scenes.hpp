#pragma once
/// Scenes without gravity in which a ball slides along a straight face, or lands on it without a bounce, and
/// leaves it where the face ends in a tangent cap, arc, circle or corner. Its way is a straight line.

#include <numbers>
#include <string_view>
#include <vector>

#include "world/scene_builder.hpp"
#include "world/world.hpp"

namespace flipside::test {

/// Turned, then shifted; lengths in radii of the ball.
struct Placement {
    double angle = 0;                ///< rad
    Vec2 origin;                     ///< m
    double radius = 0.1, speed = 1;  ///< m, m/s

    [[nodiscard]] Vec2 direction(double x, double y) const { return rotated({x, y}, angle); }
    [[nodiscard]] Vec2 at(double x, double y) const { return origin + radius * direction(x, y); }
};

struct Slide {
    std::string_view name;
    Scene scene;
    double flipper_angle = 0;  ///< of part 0 when it begins, at a stop, rad
    Vec2 end;                  ///< of the ball after `seconds`
    double seconds = 0;
};

/// Over 12 radii, of which the last nine are beyond the face.
inline std::vector<Slide> slides(const Placement& p) {
    using std::numbers::pi;
    const double r = p.radius, cap = 2 * r, high = 3;
    std::vector<Slide> all;
    const auto begin = [&](std::string_view name) -> Scene& {
        Slide& slide = all.emplace_back();
        slide.name = name;
        slide.scene = empty_scene();
        slide.scene.bounds = {p.origin - Vec2{100 * r, 100 * r}, p.origin + Vec2{100 * r, 100 * r}};
        slide.seconds = 12 * r / p.speed;
        return slide.scene;
    };
    const Material dead{"", 0, 0, 0};
    const auto slide_at = [&](double height) {
        add_ball(all.back().scene, p.at(0, height), p.speed * p.direction(1, 0), r);
        all.back().end = p.at(12, height);
    };
    const auto land_at = [&](double height) {  // falls one radius over the first two radii of way
        add_ball(all.back().scene, p.at(0, height + 1), p.speed * p.direction(1, -0.5), r);
        all.back().end = p.at(12, height);
    };
    const Shape capsule{shape::Capsule{p.at(-8, 0), p.at(3, 0), cap}};
    add_part(begin("capsule"), capsule, dead);
    slide_at(high);
    add_part(begin("capsule, landing"), capsule, dead);
    land_at(high);
    add_part(begin("capsule in a compound"), {shape::Compound{{capsule, {shape::Circle{p.at(-8, -6), r}}}}},
             dead);
    slide_at(high);
    add_part(begin("polygon"), {shape::Polygon{{p.at(-8, 0), p.at(0, -4), p.at(3, 0)}}}, dead);
    slide_at(1);

    const Shape face = segment(p.at(-8, 0), p.at(3, 0));
    const Shape down{shape::Arc{p.at(3, -2), cap, p.angle, p.angle + pi / 2}};
    add_part(begin("segment and arc"), {shape::Compound{{face, down}}}, dead);
    slide_at(1);
    {
        Scene& scene = begin("segment and arc of two parts");
        add_part(scene, face, dead);
        add_part(scene, down, dead);
    }
    slide_at(1);
    {
        Scene& scene = begin("segment and a circle");
        add_part(scene, face, dead);
        add_part(scene, {shape::Circle{p.at(3, -2), cap}}, dead);
    }
    land_at(1);
    {
        Scene& scene = begin("three segments and a capsule");
        add_part(scene, {shape::Polyline{{p.at(-8, 0), p.at(-2, 0), p.at(1, 0), p.at(2, 0)}, false}}, dead);
        add_part(scene, {shape::Capsule{p.at(2, -1), p.at(3, -1), r}}, dead);
    }
    slide_at(1);
    {
        Scene& scene = begin("channel");
        add_part(scene, capsule, dead);
        add_part(scene, {shape::Capsule{p.at(-8, 6), p.at(3, 6), cap}}, dead);
    }
    slide_at(high);

    for (const double raised : {0.0, 0.7}) {
        const double base = 2.5, tip = 1.5, length = 6, rest = p.angle;
        Part& part = add_part(begin(raised == 0 ? "flipper" : "raised flipper"),
                              {shape::Flipper{p.origin, length * r, base * r, tip * r, rest}}, dead);
        part.motion = motion::Flip{Side::left, rest + 0.7, 10, 10};
        // The outward normal of the upper side makes the angle acos((base − tip)/length) with the axis.
        Placement side = p;
        if (raised != 0) all.back().flipper_angle = (rest + 0.7) - rest;
        side.angle = p.angle + all.back().flipper_angle + std::acos((base - tip) / length) - pi / 2;
        const Vec2 from = side.at(2, base + 1);
        add_ball(all.back().scene, from, p.speed * side.direction(1, 0), r);
        all.back().end = side.at(14, base + 1);
    }
    return all;
}

/// How far from its straight way the ball ends, in radii, stepped by dt.
inline double strays(World& world, const Slide& slide, double dt) {
    if (slide.flipper_angle != 0) {
        State state = world.save();
        state.parts[0].angle = slide.flipper_angle;
        state.raised[0] = true;
        world.restore(state);
    }
    const auto whole = static_cast<int>(slide.seconds / dt);
    for (int i = 0; i < whole; ++i) world.step(dt);
    if (const double rest = slide.seconds - world.time(); rest > 0) world.step(rest);
    const Ball& ball = world.balls()[0];
    return length(ball.position - slide.end) / ball.radius;
}

}  // namespace flipside::test

#include "fuzz/closed_box.hpp"

#include <algorithm>
#include <cmath>

#include "custom/geometry/narrow_phase.hpp"

namespace flipside::fuzz {

namespace {

/// Limits of an everyday scene, in m, m/s and m/s².
constexpr double least_radius = 1e-4, largest_box = 100, fastest = 50;

bool is_tame(const Ball& ball, const Scene& scene) {
    const Material& material = scene.materials[ball.material];
    return ball.radius >= least_radius && length(ball.velocity) <= fastest &&
           std::abs(ball.spin) <= fastest && (ball.collides_with & 1U) != 0 && material.restitution <= 1 &&
           material.kick == 0;
}

bool is_tame(const Part& part, const Scene& scene) {
    const Material& material = scene.materials[part.material];
    return !Table::moves(part) && !part.target && material.restitution <= 1 && material.kick == 0;
}

void include(Box& box, const Ball& ball) {
    box.min = {std::min(box.min.x, ball.position.x - ball.radius),
               std::min(box.min.y, ball.position.y - ball.radius)};
    box.max = {std::max(box.max.x, ball.position.x + ball.radius),
               std::max(box.max.y, ball.position.y + ball.radius)};
}

bool overlaps(const Ball& ball, const Primitive& primitive) {
    return custom::touch(ball.position, ball.radius, primitive).separation < 0;
}

bool apart(const Ball& a, const Ball& b) {
    return length(b.position - a.position) >= a.radius + b.radius;
}

}  // namespace

std::shared_ptr<const Scene> closed_box(const Scene& scene) {
    const auto tame = [&](const auto& thing) { return is_tame(thing, scene); };
    if (scene.balls.empty() || !std::ranges::all_of(scene.balls, tame) ||
        !std::ranges::all_of(scene.parts, tame) || length(scene.gravity) > fastest)
        return nullptr;
    const std::vector<Primitive> surface = surface_of(scene);
    Box around{scene.balls[0].position, scene.balls[0].position};
    for (std::size_t i = 0; i < scene.balls.size(); ++i) {
        include(around, scene.balls[i]);
        for (std::size_t j = 0; j < i; ++j)
            if (!apart(scene.balls[j], scene.balls[i])) return nullptr;
        for (const Primitive& primitive : surface)
            if (overlaps(scene.balls[i], primitive)) return nullptr;
    }
    if (!(length(around.max - around.min) <= largest_box)) return nullptr;
    const Vec2 margin{0.1 * (around.max.x - around.min.x), 0.1 * (around.max.y - around.min.y)};
    around = {around.min - margin, around.max + margin};
    auto closed = std::make_shared<Scene>(scene);
    closed->launcher.reset();
    closed->rules.reset();
    closed->bounds = {around.min - margin, around.max + margin};
    Part wall;
    wall.name = "closed-box";
    wall.shape.is = shape::Polyline{
        {around.min, {around.max.x, around.min.y}, around.max, {around.min.x, around.max.y}}, true};
    closed->parts.push_back(wall);
    return closed;
}

}  // namespace flipside::fuzz

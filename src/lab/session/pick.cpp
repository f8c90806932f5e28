#include "lab/session/pick.hpp"

#include <algorithm>

#include "custom/geometry/narrow_phase.hpp"
#include "world/bounds.hpp"

namespace flipside::lab {

std::optional<Other> pick(const Scene& scene, std::span<const Ball> balls, std::span<const PartState> parts,
                          Vec2 point, double reach) {
    std::optional<Other> nearest;
    double least = reach;
    const auto consider = [&](double distance, Other what) {
        if (distance > least) return;
        least = distance;
        nearest = what;
    };
    for (const Ball& ball : balls)
        consider(length(point - ball.position) - ball.radius, Other::ball(ball.number));
    if (nearest) return nearest;
    for (const Primitive& primitive : surface_of(scene)) {
        const Pose pose = pose_of(scene.parts[primitive.part], parts[primitive.part]);
        consider(custom::touch(point, 0, primitive, pose).separation, Other::part(primitive.part));
    }
    return nearest;
}

Box extent_of(const Scene& scene, std::span<const PartState> parts, PartIndex part) {
    std::optional<Box> extent;
    for (const Primitive& primitive : surface_of(scene)) {
        if (primitive.part != part) continue;
        const Box box = bounds_of(primitive, pose_of(scene.parts[part], parts[part]));
        extent = extent ? united(*extent, box) : box;
    }
    return extent.value_or(scene.bounds);
}

bool is_free(const Scene& scene, std::span<const Ball> balls, std::span<const PartState> parts,
             const Ball& ball) {
    const auto overlaps_ball = [&](const Ball& other) {
        return layers_meet(ball, other) &&
               length(ball.position - other.position) < ball.radius + other.radius;
    };
    const auto overlaps_primitive = [&](const Primitive& primitive) {
        const Part& part = scene.parts[primitive.part];
        if (part.sensor || parts[primitive.part].down || !layers_meet(ball, part)) return false;
        const Pose pose = pose_of(part, parts[primitive.part]);
        return custom::touch(ball.position, ball.radius, primitive, pose).separation < 0;
    };
    return scene.bounds.contains(ball.position) && std::ranges::none_of(balls, overlaps_ball) &&
           std::ranges::none_of(surface_of(scene), overlaps_primitive);
}

}  // namespace flipside::lab

#include "lab/blame/met_kind.hpp"

#include <algorithm>
#include <cmath>

#include "custom/geometry/narrow_phase.hpp"

namespace flipside::lab {

namespace {

struct KindOfPrimitive {
    std::string_view operator()(const primitive::Point&) const { return "point"; }
    std::string_view operator()(const primitive::Segment&) const { return "segment"; }
    std::string_view operator()(const primitive::Arc&) const { return "arc"; }
    std::string_view operator()(const primitive::Circle&) const { return "circle"; }
    std::string_view operator()(const primitive::Polygon&) const { return "polygon"; }
    std::string_view operator()(const primitive::Taper&) const { return "taper"; }
};

Pose pose_of(const Part& part, double angle) {
    if (const auto* turn = std::get_if<motion::Turn>(&part.motion)) return {turn->pivot, angle};
    if (const auto* flipper = std::get_if<shape::Flipper>(&part.shape.is)) return {flipper->pivot, angle};
    return {};
}

/// How a disc lies to each primitive of a part.
void each_touch(const Scene& scene, PartIndex part, const PartState& state, Vec2 center, double radius,
                const auto& visit) {
    const Pose pose = pose_of(scene.parts[part], state.angle);
    for (const Primitive& primitive : surface_of(scene))
        if (primitive.part == part) visit(primitive, custom::touch(center, radius, primitive, pose));
}

/// The primitive of a part nearest to a disc: how it is touched.
struct Nearest {
    custom::Touch touch;
    std::string_view kind = "none";
};
Nearest nearest(const Scene& scene, PartIndex part, const PartState& state, Vec2 center, double radius) {
    Nearest found;
    double least = INFINITY;
    each_touch(scene, part, state, center, radius,
               [&](const Primitive& primitive, const custom::Touch& touch) {
                   if (std::abs(touch.separation) >= least) return;
                   least = std::abs(touch.separation);
                   found = {touch, std::visit(KindOfPrimitive{}, primitive.is)};
               });
    return found;
}

}  // namespace

std::string_view met_kind(const Scene& scene, Other other, const PartState& state, Vec2 point) {
    if (other.is_ball) return "ball";
    const Part& part = scene.parts[other.index];
    if (gate_of(part) != nullptr) return "gate";
    if (std::holds_alternative<shape::Flipper>(part.shape.is)) return "flipper";
    return nearest(scene, other.index, state, point, 0).kind;
}

Vec2 surface_normal(const Scene& scene, PartIndex part, const PartState& state, Vec2 center, double radius) {
    return nearest(scene, part, state, center, radius).touch.normal;
}

double separation(const Scene& scene, PartIndex part, const PartState& state, Vec2 center, double radius) {
    double least = INFINITY;
    each_touch(scene, part, state, center, radius, [&](const Primitive&, const custom::Touch& touch) {
        least = std::min(least, touch.separation);
    });
    return least;
}

}  // namespace flipside::lab

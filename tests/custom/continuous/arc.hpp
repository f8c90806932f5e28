#pragma once
/// Features of arcs.

#include "custom/continuous/feature.hpp"

namespace flipside::custom::test {

/// The feature of an arc with a point at each end, so that it does not extend past them.
inline Arc arc_of(const primitive::Arc& arc) {
    Scene scene;
    scene.parts.emplace_back();
    std::vector<Primitive> primitives{{arc, 0}};
    for (const double end : {arc.from, arc.to})
        primitives.push_back({primitive::Point{arc.center + arc.radius * from_angle(end)}, 0});
    return std::get<Arc>(features_of(primitives, scene).front().is);
}

}  // namespace flipside::custom::test

#pragma once
/// Certificates of static heaps.

#include <cmath>

#include <nlohmann/json.hpp>

#include "heap_scenes.hpp"
#include "lab/certificates/certificate.hpp"
#include "lab/contenders/engines.hpp"

namespace flipside {

using HeapJson = nlohmann::json;

/// Balls in a groove of 60°, row by row, with a heavy one on top.
inline Scene groove(int rows, double friction) {
    Scene scene = heap_in_groove(rows, friction);
    add_ball(scene, {0, 0.2 + 0.2 * std::sqrt(0.75) * rows}, {}, 0.1, 50);
    scene.balls.back().position.x = rows % 2 == 0 ? 0 : 0.1;
    return scene;
}
inline Scene column(int balls) {
    Scene scene = empty_scene({0, -heap_gravity});
    add_part(scene, {shape::Segment{{-9, 0}, {9, 0}}});
    for (int i = 0; i < balls; ++i) add_ball(scene, {0, 0.1 + 0.2 * i}, {}, 0.1, i % 2 == 0 ? 1 : 1000);
    return scene;
}
inline HeapJson certified(Scene scene) {
    const Engine& engine = lab::engine_named("reference");
    const auto shared = std::make_shared<const Scene>(std::move(scene));
    lab::Session session(shared, engine, lab::settings_for(engine, *shared, {}));
    return HeapJson::parse(lab::certify(session, lab::Timeline(0, 0.5, lab::default_step), {}).json);
}

}  // namespace flipside

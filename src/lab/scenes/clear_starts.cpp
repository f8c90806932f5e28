#include "lab/scenes/clear_starts.hpp"

#include <memory>

#include "lab/contenders/engines.hpp"
#include "lab/session/run_settings.hpp"

namespace flipside::lab {

void clear_starts(Scene& scene) {
    const Engine& engine = engine_named("custom");
    for (;;) {
        const auto world = engine.make(std::make_shared<const Scene>(scene), settings_for(engine, scene));
        if (world->contacts().empty()) return;
        const BallNumber touching = world->contacts().front().ball;
        std::erase_if(scene.balls, [&](const Ball& ball) { return ball.number == touching; });
        for (BallNumber i = 0; i < scene.balls.size(); ++i) scene.balls[i].number = i;
    }
}

}  // namespace flipside::lab

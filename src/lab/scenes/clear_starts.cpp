#include "lab/scenes/clear_starts.hpp"

#include <algorithm>
#include <memory>

#include "lab/contenders/engines.hpp"
#include "lab/session/run_settings.hpp"

namespace flipside::lab {

void clear_starts(Scene& scene) {
    const Engine& engine = engine_named("custom");
    const auto world = engine.make(std::make_shared<const Scene>(scene), settings_for(engine, scene));
    std::erase_if(scene.balls, [&](const Ball& ball) {
        return std::ranges::binary_search(world->contacts(), ball.number, {}, &Contact::ball);
    });
    for (BallNumber i = 0; i < scene.balls.size(); ++i) scene.balls[i].number = i;
}

}  // namespace flipside::lab

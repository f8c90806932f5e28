#include "custom/engine.hpp"

#include "custom/settings.hpp"
#include "custom/world.hpp"

namespace flipside::custom {

const Engine& engine() {
    static const Engine custom{
        engine_name,
        "the bespoke engine: shapes, quadtree and response written here to be read",
        setting_specs(),
        [](std::shared_ptr<const Scene> scene, const Settings& settings) {
            return std::unique_ptr<World>(std::make_unique<CustomWorld>(std::move(scene), settings));
        },
        "",
        true};
    return custom;
}

}  // namespace flipside::custom

#include "lab/sweep/windows.hpp"

namespace flipside::lab::sweep {

Truth reference_for(const Scene& scene) {
    const Engine& engine = engine_named("reference");
    Settings settings = settings_for(engine, scene);
    return {&engine, settings, settings};
}

}  // namespace flipside::lab::sweep

#include "lab/sweep/windows.hpp"

namespace flipside::lab::sweep {

Truth reference_for(const Scene& scene) {
    const Engine* const engine = &engine_named("reference");
    const auto with = [&](const std::vector<std::string>& texts) {
        return settings_for(*engine, scene, parse_changes(texts, {&engine, 1}));
    };
    return {engine, with({"precision=53", "twin=off"}), with({"precision=113", "twin=on"})};
}

}  // namespace flipside::lab::sweep

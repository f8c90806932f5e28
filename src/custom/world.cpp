#include "custom/world.hpp"

#include "custom/broad_phase/registry.hpp"

namespace flipside::custom {

CustomWorld::CustomWorld(std::shared_ptr<const Scene> scene, const Settings& settings)
    : scene_(std::move(scene)),
      settings_(settings),
      table_(scene_),
      layout_(*scene_),
      broad_(make_broad_phase(*scene_, layout_.still_proxies(), settings)),
      balls_(scene_->balls) {
    if (settings_.solver == "simple")
        simple_ = std::make_unique<SimpleSolver>(table_, balls_, layout_, *broad_, settings_, record_);
    else
        continuous_ = std::make_unique<ContinuousSolver>(table_, layout_, *broad_, settings_);
    if (continuous_) continuous_->load(balls_);
    reserve();
    search_contacts();
    fill_statistics(0);
}

void CustomWorld::make_step(double dt) {
    const std::uint64_t tests_before = broad_->tests();
    record_.events.clear();
    record_.crossed.clear();
    record_.statistics = {};
    launch();
    if (continuous_) {
        const bool was_quiet = continuous_->quiet();
        continuous_->step(dt, balls_, record_);
        if (!was_quiet || steps_since_contacts_ > 0) ++steps_since_contacts_;
    } else {
        simple_->step(dt);
        Stopwatch watch;
        ++steps_since_contacts_;
        find_contacts();
        watch.lap(record_.statistics.stages[3]);
    }
    fill_statistics(broad_->tests() - tests_before);
    if (record_.trace)
        trace_read_out(*record_.trace, "src/custom/world.cpp: CustomWorld::make_step", *this, *scene_);
}

}  // namespace flipside::custom

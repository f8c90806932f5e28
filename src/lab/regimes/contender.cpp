#include "lab/regimes/contender.hpp"

#include "lab/contenders/engines.hpp"
#include "lab/process/cpu_clock.hpp"
#include "lab/regimes/courses.hpp"
#include "lab/session/session.hpp"

namespace flipside::lab::regimes {

std::vector<Kind> kinds() {
    std::vector<Kind> all{
        {"bare-loop", "", {}, false, false},
        {"custom-continuous", "custom", {"solver=continuous"}},
        {"custom-continuous-unread", "custom", {"solver=continuous"}, false, false},
        {"custom-simple", "custom", {"solver=simple"}, true, false},
        {"box2d", "box2d", {}},
        {"box2d-no-bullets", "box2d", {"bullets=off"}},
        {"box2d-not-continuous", "box2d", {"bullets=off", "continuous=off"}, true, false},
    };
    // The reference refuses moving balls in resting contact with each other, and most regimes have such
    // balls.
    constexpr std::string_view listed[] = {"custom", "box2d", "reference"};
    for (const Engine* engine : engines_beside(listed))
        all.push_back({std::string(engine->name), std::string(engine->name), {}});
    return all;
}

Contender::Contender(const Kind& kind, const std::shared_ptr<const Scene>& scene)
    : scene_(scene), reads_(kind.reads) {
    if (kind.engine.empty()) {
        bare_.emplace(*scene);
        return;
    }
    const Engine& used = engine_named(kind.engine);
    const Engine* const one[] = {&used};
    world_ = used.make(scene, settings_for(used, *scene, parse_changes(kind.changes, one)));
}

Slice Contender::run(int steps) {
    Slice slice;
    double elsewhere = 0;  // s, of an engine in a process of its own
    bool is_elsewhere = false;
    const CpuStopwatch watch;
    for (int i = 0; i < steps; ++i) {
        slice.ball_steps += bare_ ? scene_->balls.size() : world_->balls().size();
        if (bare_) {
            bare_->step(static_cast<float>(dt));
            continue;
        }
        world_->step(dt);
        if (reads_) static_cast<void>(world_->events()), static_cast<void>(world_->contacts());
        for (const StageTime& stage : world_->statistics().stages) slice.own += stage.seconds;
        if (const auto told = world_->statistics().cpu_seconds) is_elsewhere = true, elsewhere += *told;
    }
    slice.seconds = is_elsewhere ? elsewhere : watch.seconds();
    if (world_) slice.deepest = deepest_overlap(world_->contacts()) / scene_->balls.front().radius;
    return slice;
}

std::size_t Contender::balls() const {
    return bare_ ? scene_->balls.size() - bare_->lost() : world_->balls().size();
}

double Contender::energy() const {
    return bare_ ? 0 : lab::energy(*world_, *scene_);
}

}  // namespace flipside::lab::regimes

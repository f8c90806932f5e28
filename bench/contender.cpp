#include "contender.hpp"

#include "lab/contenders/engines.hpp"
#include "lab/process/cpu_clock.hpp"
#include "lab/session/session.hpp"

namespace flipside::bench {

Contender::Contender(const Kind& kind, const std::shared_ptr<const Scene>& scene)
    : scene_(scene), reads_(kind.reads) {
    if (kind.engine.empty()) {
        bare_.emplace(*scene);
        return;
    }
    const Engine& used = lab::engine_named(kind.engine);
    const Engine* const one[] = {&used};
    world_ = used.make(scene, lab::settings_for(used, *scene, lab::parse_changes(kind.changes, one)));
}

void Contender::run(int steps, bool timed) {
    if (timed && ball_steps_ == 0 && world_) {
        first_energy_ = lab::energy(*world_, *scene_);
        first_balls_ = world_->balls().size();
    }
    const lab::CpuStopwatch watch;
    for (int i = 0; i < steps; ++i) {
        if (timed) ball_steps_ += world_ ? world_->balls().size() : scene_->balls.size();
        if (bare_) {
            bare_->step(static_cast<float>(dt));
            continue;
        }
        world_->step(dt);
        if (reads_) static_cast<void>(world_->events()), static_cast<void>(world_->contacts());
        if (timed)
            for (const StageTime& stage : world_->statistics().stages) own_seconds_ += stage.seconds;
    }
    if (!timed) return;
    seconds_ += watch.seconds();
    if (world_)
        deepest_ = std::max(deepest_, deepest_overlap(world_->contacts()) / scene_->balls.front().radius);
}

std::size_t Contender::lost() const {
    return bare_ ? bare_->lost() : first_balls_ - world_->balls().size();
}

std::size_t Contender::asleep() const {
    return bare_ ? 0 : static_cast<std::size_t>(std::ranges::count_if(world_->balls(), &Ball::asleep));
}

double Contender::drift() const {
    return bare_ ? 0 : (lab::energy(*world_, *scene_) - first_energy_) / first_energy_;
}

}  // namespace flipside::bench

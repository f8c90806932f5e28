#include "lab/blame/blame_run.hpp"

#include "lab/blame/continuation.hpp"
#include "lab/blame/find_blame.hpp"
#include "lab/contenders/engines.hpp"
#include "lab/session/run.hpp"
#include "world/refusal.hpp"

namespace flipside::lab {

namespace {

std::unique_ptr<World> make_exact(const std::shared_ptr<const Scene>& scene) {
    const Engine& engine = engine_named("reference");
    return engine.make(scene, settings_for(engine, *scene));
}

/// A session of the reference that knows its horizon.
Session judge_of(const std::shared_ptr<const Scene>& scene) {
    const Engine& engine = engine_named("reference");
    Settings settings = settings_for(engine, *scene);
    settings.set("precision", "53");
    settings.set("twin", "on");
    return {scene, engine, settings};
}

/// The balls that the reference still claims.
std::vector<KnownEnd> judged(const World& reference) {
    std::vector<KnownEnd> ends;
    const auto balls = reference.balls();
    const auto claimed = reference.uncertainty();
    for (std::size_t i = 0; i < balls.size() && i < claimed.size(); ++i)
        if (claimed[i] <= judged_radii * balls[i].radius)
            ends.push_back({balls[i].number, balls[i].position, balls[i].radius});
    return ends;
}

}  // namespace

RunBlame blame_run(const std::shared_ptr<const Scene>& scene, const Contender& contender, double seconds,
                   const Script& script, const std::function<void(double)>& watch) {
    RunBlame result;
    try {
        Session own(scene, *contender.engine, contender.settings), reference = judge_of(scene);
        History history;
        history.script = script;
        history.dt = contender.dt;
        history.begin(own.world());
        const Timeline timeline(0, seconds, contender.dt);
        std::size_t next = 0, next_of_reference = 0;
        for (std::uint64_t k = 0; k < timeline.steps(); ++k) {
            own.step(timeline.length(k), script, next);
            check_finite(own, own.world().time());
            reference.step(timeline.length(k), script, next_of_reference);
            history.add(own.world(), own.events());
            const std::vector<KnownEnd> ends = judged(reference.world());
            const Worst apart = worst(own.world().balls(), ends);
            if (apart.radii > diverged_radii) {
                history.end = own.world().time();
                result.until = history.end;
                result.radii = apart.radii;
                result.ball = apart.ball;
                const auto exact = make_exact(scene);
                result.blame = find_blame({*scene, history, ends, apart.radii, &own.world()}, *exact);
                return result;
            }
            if (ends.empty() && !reference.world().balls().empty()) {
                result.why = "then no ball is known any more";
                return result;
            }
            result.until = k + 1 == timeline.steps() ? timeline.end() : own.world().time();
            watch(result.until);
        }
    } catch (const std::runtime_error& error) {
        result.why = error.what();
    }
    return result;
}

}  // namespace flipside::lab

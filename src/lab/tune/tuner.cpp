#include "lab/tune/tuner.hpp"

#include <algorithm>

#include "lab/sweep/contenders.hpp"
#include "lab/tune/search_space.hpp"

namespace flipside::lab::tune {

namespace {

/// What is cheaper by less is not told from noise.
constexpr double worth = 0.97;
/// What is dearer than so many times the engine as it comes at the shortest step is not looked at.
constexpr double times_the_finest = 8;

std::vector<double> steps_to(int finest) {
    std::vector<double> steps;
    for (int n = sweep::coarsest_steps; n <= finest; n *= 2) steps.push_back(1.0 / n);
    return steps;
}

}  // namespace

Tuner::Tuner(const Engine& engine, const Trials& trials, int finest, double most_seconds)
    : engine_(engine),
      trials_(trials),
      steps_(steps_to(finest)),
      plain_{&engine_, settings_for(engine_, trials_.scene()), std::string(engine_.name), steps_.front()},
      start_(plain_),
      most_seconds_(most_seconds / 2) {
    constexpr double any = std::numeric_limits<double>::infinity();
    Contender at_finest = plain_;
    at_finest.dt = steps_.back();
    most_cost_ = times_the_finest * trials_.score(at_finest, any, any).cost;
}

/// Meets the target and costs less; or, where nothing met it so far, meets it or comes closer.
bool Tuner::take(Found& best, const Contender& other, double target) {
    const bool in_time = best.tried == 0 || watch_.seconds() < most_seconds_;
    if (best.tried >= most_trials || !in_time || !tried_.insert(text_of(other, trials_.scene())).second)
        return false;
    ++best.tried;
    const bool met = best.score.error <= target;
    const Score score =
        trials_.score(other, met ? target : best.score.error, met ? best.score.cost : most_cost_);
    const bool better = met ? score.error <= target && score.cost < worth * best.score.cost
                            : score.error < worth * best.score.error;
    if (!better) return false;
    best.contender = other;
    best.score = score;
    return true;
}

bool Tuner::improve_step(Found& best, double target) {
    bool improved = false;
    for (const double dt : steps_) {
        Contender other = best.contender;
        other.dt = dt;
        improved |= take(best, other, target);
    }
    return improved;
}

bool Tuner::improve_setting(Found& best, const SettingSpec& spec, double target) {
    if (!best.contender.settings.idle(spec.name).empty()) return false;
    bool improved = false;
    for (const std::string& value : candidates_of(spec)) {
        Contender other = best.contender;
        other.settings.set(spec.name, value);
        improved |= take(best, other, target);
    }
    return improved;
}

Found Tuner::descend(const Contender& start, double target) {
    Found best{start};
    tried_.clear();
    watch_ = {};
    take(best, start, target);
    for (bool improved = true; improved && best.tried < most_trials;) {
        improved = improve_step(best, target);
        for (const SettingSpec& spec : engine_.settings) improved |= improve_setting(best, spec, target);
    }
    return best;
}

Found Tuner::cheapest(double target) {
    Contender at_finest = plain_;
    at_finest.dt = steps_.back();
    Found best = descend(start_, target), other = descend(at_finest, target);
    const std::size_t tried = best.tried + other.tried;
    const bool met = best.score.error <= target, other_met = other.score.error <= target;
    const bool is_better =
        met && other_met ? other.score.cost < best.score.cost : other.score.error < best.score.error;
    if (met == other_met ? is_better : other_met) best = std::move(other);
    best.tried = tried;
    start_ = best.contender;
    return best;
}

Found untuned(const Engine& engine, const Trials& trials, int finest, double target,
              std::span<const SettingChange> changes) {
    constexpr double any = std::numeric_limits<double>::infinity();
    Found found{{&engine, settings_for(engine, trials.scene(), changes), std::string(engine.name)}};
    for (const double dt : steps_to(finest)) {
        found.contender.dt = dt;
        found.score = trials.score(found.contender, any, any);
        ++found.tried;
        if (found.score.error <= target) break;
    }
    return found;
}

}  // namespace flipside::lab::tune

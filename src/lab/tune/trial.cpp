#include "lab/tune/trial.hpp"

#include <algorithm>
#include <cmath>

#include "lab/process/cpu_clock.hpp"
#include "lab/sweep/measure.hpp"
#include "world/input_error.hpp"
#include "world/refusal.hpp"

namespace flipside::lab::tune {

namespace {

/// Null where the engine cannot run the scene with these settings.
std::unique_ptr<World> try_to_make(const Contender& contender, const std::shared_ptr<const Scene>& scene) {
    try {
        return contender.engine->make(scene, contender.settings);
    } catch (const InputError&) {
        return nullptr;
    } catch (const Refusal&) {
        return nullptr;
    }
}

/// Not a number where the run failed.
double least_time(World& world, const sweep::Window& window, double dt) {
    double least = sweep::time_window(world, window, dt);
    for (std::size_t round = 1; round < repeats; ++round)
        least = std::min(least, sweep::time_window(world, window, dt));
    return least;
}

}  // namespace

Trials::Trials(const sweep::Variant& variant, std::uint64_t seed, std::uint32_t block, std::size_t windows,
               const std::function<void()>& watch)
    : scene_(sweep::load(variant)), watch_(watch) {
    block_ = sweep::make_block({variant, seed, block, windows}, scene_, sweep::reference_for(*scene_), watch);
    if (block_.windows.empty())
        throw InputError(
            "scene '" + variant.name +
            "' gives no windows to tune on: nothing hits anything in it that the reference knows");
}

double Trials::error(const Contender& contender) const {
    constexpr double any = std::numeric_limits<double>::infinity();
    const auto world = try_to_make(contender, scene_);
    return world ? median_error(*world, contender.dt, any, any) : any;
}

double Trials::median_error(World& world, double dt, double most_error, double most_cost) const {
    std::vector<double> errors;
    std::size_t above = 0;
    double seconds = 0;
    const double began = cpu_seconds();
    for (const sweep::Window& window : block_.windows) {
        watch_();
        History unused;
        seconds += window.seconds;
        const double left = 2 * most_cost * seconds - (cpu_seconds() - began);
        errors.push_back(sweep::run_window(world, window, dt, unused, left).error);
        above += errors.back() > most_error;
        if (2 * above > block_.windows.size() || cpu_seconds() - began > 2 * most_cost * seconds)
            return std::numeric_limits<double>::infinity();
    }
    const auto middle = errors.begin() + static_cast<std::ptrdiff_t>(errors.size() / 2);
    std::ranges::nth_element(errors, middle);
    return *middle;
}

Score Trials::score(const Contender& contender, double most_error, double most_cost) const {
    const auto world = try_to_make(contender, scene_);
    if (!world) return {};
    Score score{.error = median_error(*world, contender.dt, most_error, most_cost)};
    if (!std::isfinite(score.error)) return score;
    double seconds = 0, spent = 0;
    const std::size_t every = std::max<std::size_t>(1, block_.windows.size() / timed);
    for (std::size_t i = 0; i < block_.windows.size(); i += every) {
        watch_();
        const double time = least_time(*world, block_.windows[i], contender.dt);
        if (std::isnan(time)) continue;
        spent += time;
        seconds += block_.windows[i].seconds;
    }
    if (seconds > 0) score.cost = spent / seconds;
    return score;
}

std::vector<std::vector<double>> Trials::times(std::span<const Contender> contenders) const {
    std::vector<std::unique_ptr<World>> worlds;
    for (const Contender& contender : contenders) worlds.push_back(try_to_make(contender, scene_));
    std::vector<std::vector<double>> all(contenders.size());
    for (const sweep::Window& window : block_.windows) {
        std::vector<double> least(contenders.size(), std::numeric_limits<double>::infinity());
        for (std::size_t round = 0; round < repeats; ++round)
            for (std::size_t i = 0; i < contenders.size(); ++i) {
                watch_();
                const double time =
                    worlds[i] ? sweep::time_window(*worlds[i], window, contenders[i].dt) : std::nan("");
                least[i] = std::isnan(time) || std::isnan(least[i]) ? std::nan("") : std::min(least[i], time);
            }
        for (std::size_t i = 0; i < contenders.size(); ++i) all[i].push_back(least[i] / window.seconds);
    }
    return all;
}

}  // namespace flipside::lab::tune

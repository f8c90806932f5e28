#include "lab/sweep/unit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "world/input_error.hpp"
#include "world/refusal.hpp"

namespace flipside::lab::sweep {

namespace {

constexpr double not_timed = std::numeric_limits<double>::quiet_NaN();

/// A contender's world for a scene, or why there is none.
struct Made {
    std::unique_ptr<World> world;
    std::string why;
};

/// A contender at one step size.
struct Lane {
    const Contender* contender;
    const Made* made;  ///< of the contender, the same at all its step sizes
    double dt;
};

/// A run to make, and what it takes.
struct Task {
    const Lane* lane;
    std::size_t window;  ///< of the block
    bool timed;
    double work;  ///< balls times steps
    std::vector<double> cpu{};
};

/// An engine that cannot run the scene fails in every window of it; the others do not.
Made make_world(const Contender& contender, const std::shared_ptr<const Scene>& scene) {
    const Settings settings = settings_of(contender, *scene);
    try {
        return {engine_named(contender.engine).make(scene, settings), ""};
    } catch (const InputError& error) {
        return {nullptr, error.what()};
    } catch (const Refusal& refusal) {
        return {nullptr, refusal.what()};
    }
}

/// The windows of the block that are run at this step size.
std::vector<std::size_t> windows_at(double dt, const Plan& plan, const Unit& unit, const Block& block) {
    std::vector<std::size_t> windows;
    for (std::size_t i = 0; i < block.windows.size(); ++i) {
        const double longest = unit.variant->longest * window_unit;
        const std::size_t number = unit.block * plan.block_size + i;
        if (number % thinning(plan, block.windows[i].start.balls.size(), longest, dt) == 0)
            windows.push_back(i);
    }
    return windows;
}

std::vector<Task> tasks_of(const Plan& plan, const Unit& unit, const Block& block,
                           const std::vector<Lane>& lanes) {
    std::vector<Task> tasks;
    for (const Lane& lane : lanes)
        for (const std::size_t i : windows_at(lane.dt, plan, unit, block)) {
            const Window& window = block.windows[i];
            const auto balls = static_cast<double>(window.start.balls.size());
            tasks.push_back({&lane, i, i < plan.timed, balls * window.seconds / lane.dt});
        }
    return tasks;
}

/// `exact` is the reference, for blame.
Run run_of(const Task& task, const Plan& plan, const Unit& unit, const Block& block, const Scene& scene,
           World& exact) {
    const Window& window = block.windows[task.window];
    const Lane& lane = *task.lane;
    History history;
    Run run{unit.variant->name,
            std::string(lane.contender->name),
            lane.dt,
            unit.block * plan.block_size + task.window,
            window.seconds,
            lane.made->world ? run_window(*lane.made->world, window, lane.dt, history)
                             : refused_window(window, lane.dt, lane.made->why),
            {},
            not_timed,
            not_timed};
    if (diverged(run.outcome))
        run.blame =
            charge_of(blame_of(run.outcome, window, history, scene, lane.made->world.get(), exact), scene);
    return run;
}

void note_times(Run& run, std::vector<double> cpu) {
    if (cpu.empty() || std::ranges::any_of(cpu, [](double time) { return std::isnan(time); })) return;
    std::ranges::sort(cpu);
    run.cpu_min = cpu.front();
    run.cpu_median = cpu[(cpu.size() - 1) / 2];
}

}  // namespace

std::vector<Run> measure_unit(const Plan& plan, const Unit& unit, const Block& block,
                              const std::shared_ptr<const Scene>& scene,
                              const std::function<void(double)>& watch) {
    std::vector<Made> made;
    made.reserve(plan.contenders.size());
    std::vector<Lane> lanes;
    for (const Contender* contender : plan.contenders) {
        made.push_back(make_world(*contender, scene));
        for (const double dt : steps_of(*contender, plan)) lanes.push_back({contender, &made.back(), dt});
    }
    std::vector<Task> tasks = tasks_of(plan, unit, block, lanes);
    const auto rounds = static_cast<double>(plan.repetitions);
    double whole = 0, done = 0;
    for (const Task& task : tasks) whole += task.work * (task.timed ? 1 + rounds : 1);
    const auto did = [&](const Task& task) { watch((done += task.work) / whole); };

    const Truth truth = reference_for(*scene);
    const auto exact = truth.engine->make(scene, truth.trajectory);
    std::vector<Run> runs;
    for (const Task& task : tasks) {
        runs.push_back(run_of(task, plan, unit, block, *scene, *exact));
        did(task);
    }
    for (std::size_t round = 0; round < plan.repetitions; ++round)
        for (Task& task : tasks) {
            if (!task.timed || !task.lane->made->world) continue;
            task.cpu.push_back(
                time_window(*task.lane->made->world, block.windows[task.window], task.lane->dt));
            did(task);
        }
    for (std::size_t i = 0; i < runs.size(); ++i) note_times(runs[i], tasks[i].cpu);
    return runs;
}

void require_all_runs(const std::vector<Run>& runs, const Plan& plan, const Unit& unit, const Block& block,
                      const std::filesystem::path& file) {
    std::size_t wanted = 0;
    for (const Contender* contender : plan.contenders)
        for (const double dt : steps_of(*contender, plan)) wanted += windows_at(dt, plan, unit, block).size();
    if (runs.size() != wanted)
        throw InputError(
            file.string(), "",
            "has " + std::to_string(runs.size()) + " runs; its windows make " + std::to_string(wanted));
}

}  // namespace flipside::lab::sweep

#pragma once
/// The bespoke engine's world: joins table, broad phase, solver and reports behind the World interface.

#include <memory>

#include "custom/continuous/continuous_solver.hpp"
#include "custom/discrete/discrete_solver.hpp"
#include "custom/engine.hpp"
#include "custom/simple/simple_solver.hpp"
#include "custom/sleep.hpp"
#include "world/step_guard.hpp"
#include "world/world.hpp"

namespace flipside::custom {

class CustomWorld final : public World {
  public:
    CustomWorld(std::shared_ptr<const Scene> scene, const Settings& settings);

    void step(double dt) override;
    void apply(const Control& control) override;
    BallNumber add(const Ball& ball) override;
    bool remove(BallNumber number) override;

    [[nodiscard]] double time() const override { return table_.time(); }
    [[nodiscard]] std::span<const Ball> balls() const override { return balls_; }
    [[nodiscard]] std::span<const PartState> parts() const override { return table_.parts(); }
    [[nodiscard]] std::span<const Event> events() const override { return record_.events; }
    [[nodiscard]] std::span<const Contact> contacts() const override { return touches_.contacts(); }
    [[nodiscard]] const Statistics& statistics() const override { return record_.statistics; }

    [[nodiscard]] State save() const override;
    void restore(const State& state) override;
    void inspect(Inspector& inspector) const override;

  private:
    [[nodiscard]] bool steps_simply() const { return settings_.solver == "simple"; }
    [[nodiscard]] bool steps_continuously() const;
    [[nodiscard]] bool falls_asleep() const { return settings_.sleep && !steps_simply(); }
    [[nodiscard]] std::uint64_t box_tests() const;
    void make_step(double dt);
    void step_in_windows(double dt);
    void begin_window();
    void end_window();
    void load(const State& state);
    bool resume(const State& state);
    [[nodiscard]] static std::shared_ptr<const State> origin_of(const State& start);
    void launch();
    void make_room();
    bool look_over(auto&& each_ball);
    void look_over_all();
    bool lose_balls();
    void report_simple();
    void report_continuous();
    void find_touches();
    void report_discrete();
    void sort_events();
    void wake_all();
    void fill_statistics(std::uint64_t pair_tests);
    void inspect_boxes(Inspector& inspector) const;
    void inspect_turning_bounds(Inspector& inspector) const;

    std::shared_ptr<const Scene> scene_;
    SolverSettings settings_;
    Table table_;
    Layout layout_;
    std::unique_ptr<BroadPhase> broad_;
    SimpleSolver simple_;
    DiscreteSolver discrete_;
    ContinuousSolver continuous_;
    bool was_continuous_ = false;  ///< the last step was, and nothing was removed or restored since
    bool in_window_ = false;  ///< of the continuous solver; nothing else has changed anything since it began
    double window_end_ = 0;   ///< s
    Sleep sleep_;
    bool any_asleep_ = false;  ///< at the end of the step
    TouchList touches_;
    std::vector<Ball> balls_;  ///< by rising number
    StepRecord record_;
    StepGuard guard_{engine_name};
};

}  // namespace flipside::custom

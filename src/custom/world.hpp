#pragma once
/// The world of the bespoke engine: table, broad phase, solver and reports behind the World interface.

#include <memory>

#include "custom/continuous/continuous_solver.hpp"
#include "custom/engine.hpp"
#include "custom/simple/simple_solver.hpp"
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

    [[nodiscard]] Clock clock() const override { return table_.clock(); }
    [[nodiscard]] bool launch_waiting() const override { return table_.launch_waiting(); }
    [[nodiscard]] std::span<const Ball> balls() const override { return balls_; }
    [[nodiscard]] std::span<const PartState> parts() const override { return table_.parts(); }
    [[nodiscard]] std::span<const Event> events() const override;
    [[nodiscard]] std::span<const Contact> contacts() const override;
    [[nodiscard]] const Statistics& statistics() const override { return record_.statistics; }

    [[nodiscard]] State save() const override;
    void restore(const State& state) override;
    void inspect(Inspector& inspector) const override;
    void trace(Trace* trace) override { record_.trace = trace; }

  private:
    // world.cpp
    void make_step(double dt);
    // read_out.cpp
    void find_contacts() const;
    void search_contacts();
    void fill_statistics(std::uint64_t pair_tests);
    // world_changes.cpp
    void reserve();
    BallNumber append(const Ball& ball);
    void launch();
    void wake_all();
    void interrupt();
    void reload(auto&& how);
    void load(const State& state);
    bool resume(const State& state);
    void wake_restless();
    void step_with_undo(double dt);

    std::shared_ptr<const Scene> scene_;
    SolverSettings settings_;
    Table table_;
    Layout layout_;
    std::unique_ptr<BroadPhase> broad_;
    std::unique_ptr<SimpleSolver> simple_;          ///< if the solver is this one
    std::unique_ptr<ContinuousSolver> continuous_;  ///< if it is this one
    std::vector<Ball> balls_;                       ///< sorted by number
    StepGuard guard_{engine_name};
    // After a step of the continuous solver, contacts and their begin and end events are found on request.
    mutable std::uint64_t steps_since_contacts_ = 0;  ///< steps that may have changed them
    mutable TouchList contacts_{layout_, table_, *broad_, touch_distance};
    mutable StepRecord record_;
};

}  // namespace flipside::custom

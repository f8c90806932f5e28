#pragma once
/// A world whose balls stay where they are, for tests of what is done with worlds. Those that need more of it
/// override that.

#include "world/world.hpp"

namespace flipside::test {

class FakeWorld : public World {
  public:
    explicit FakeWorld(std::span<const Ball> balls) : balls_(balls.begin(), balls.end()) {}

    void step(double dt) override { time_ += dt; }
    void apply(const Control& /*control*/) override {}
    BallNumber add(const Ball& /*ball*/) override { return 0; }
    bool remove(BallNumber /*number*/) override { return false; }
    [[nodiscard]] Clock clock() const override { return {time_, 0}; }
    [[nodiscard]] std::span<const Ball> balls() const override { return balls_; }
    [[nodiscard]] std::span<const PartState> parts() const override { return {}; }
    [[nodiscard]] std::span<const Event> events() const override { return {}; }
    [[nodiscard]] std::span<const Contact> contacts() const override { return {}; }
    [[nodiscard]] const Statistics& statistics() const override { return statistics_; }
    [[nodiscard]] State save() const override {
        State state;
        state.clock.time = time_;
        state.balls = balls_;
        return state;
    }
    void restore(const State& state) override { time_ = state.clock.time; }
    void inspect(Inspector& /*inspector*/) const override {}
    void trace(Trace* /*trace*/) override {}

  protected:
    std::vector<Ball> balls_;
    Statistics statistics_;
    double time_ = 0;
};

}  // namespace flipside::test

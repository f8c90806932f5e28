#pragma once
/// The simple solver: the loop of a small engine, written to be read from top to bottom in the order of a
/// step.
///
///     motion_iterations × ( move every ball
///                           broad phase: pairs of overlapping boxes
///                           gates: decide which balls may pass
///                           collision_iterations × ( for each pair: narrow phase, response )
///                           sensors )
///
/// Collisions are tested only at the positions after each motion (discrete collision detection). So a ball
/// that moves farther than its diameter passes thin parts, impacts are found up to one motion iteration late,
/// in heaps some overlap remains, and the result depends on the order of the pairs. Section 2 of
/// docs/engine.md tells how large these errors are. No ball ever sleeps.
///
/// Cost per step: motion_iterations × (broad phase + collision_iterations × pairs).

#include "custom/flight.hpp"
#include "custom/layout.hpp"
#include "custom/response.hpp"
#include "custom/settings.hpp"
#include "custom/step_record.hpp"
#include "custom/tolerances.hpp"
#include "custom/trace/simple_trace.hpp"

namespace flipside::custom {

class SimpleSolver {
  public:
    /// Keeps references to all arguments.
    SimpleSolver(Table& table, std::vector<Ball>& balls, const Layout& layout, BroadPhase& broad,
                 const SolverSettings& settings, StepRecord& record);

    /// Moves balls and table by dt seconds.
    void step(double dt);
    /// Reserves memory for so many balls, so that steps allocate nothing.
    void reserve(std::size_t balls);

  private:
    void move_balls(const TimeInterval& interval);
    void find_pairs();
    void decide_gate(PartIndex part, double before);
    bool respond_to_pairs(double duration, int round);
    bool respond_to_primitive(Ball& ball, PrimitiveIndex index, const Surroundings& around);
    bool respond_to_ball(Ball& lower, Ball& upper, const Surroundings& around);
    void report(const Ball& ball, Other other, const Impact& impact, Vec2 point);
    void watch_sensors();

    [[nodiscard]] bool is_ball(Handle handle) const { return handle >= layout_.size(); }
    [[nodiscard]] std::size_t index_of(Handle ball) const { return ball - layout_.size(); }

    Table& table_;
    const Scene& scene_;
    std::vector<Ball>& balls_;
    const Layout& layout_;
    BroadPhase& broad_;
    const SolverSettings& settings_;
    StepRecord& record_;

    double ahead_ = 0;           ///< s from the table's time to the end of this motion iteration
    std::vector<Vec2> started_;  ///< m, per ball: centre before this motion iteration
    std::vector<Proxy> moving_;  ///< turning primitives, then balls
    std::vector<Pair> pairs_;
    std::unique_ptr<SimpleTrace> trace_;  ///< null if no trace is wanted
};

}  // namespace flipside::custom

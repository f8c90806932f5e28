#pragma once
/// The part of a world that is the same in every engine: the clock, the controls, where the moving parts
/// are, which gates are open and targets down, and the balls waiting to be launched. Every engine owns
/// one, so engines can only differ in what they do with balls.

#include <algorithm>
#include <limits>
#include <memory>
#include <optional>
#include <span>

#include "world/events.hpp"
#include "world/state.hpp"

namespace flipside {

/// A turn about a point, from the pose in the scene file.
struct Pose {
    Vec2 pivot;
    double angle = 0;

    [[nodiscard]] Vec2 apply(Vec2 p) const { return angle == 0 ? p : pivot + rotated(p - pivot, angle); }
    [[nodiscard]] Vec2 undo(Vec2 p) const { return angle == 0 ? p : pivot + rotated(p - pivot, -angle); }
};

/// Where a part stands in that state.
[[nodiscard]] inline Pose pose_of(const Part& part, const PartState& state) {
    if (const auto* turn = std::get_if<motion::Turn>(&part.motion)) return {turn->pivot, state.angle};
    if (const auto* flipper = std::get_if<shape::Flipper>(&part.shape.is))
        return {flipper->pivot, state.angle};
    return {};
}

template <class T>
void sort_unique(std::vector<T>& list) {
    std::ranges::sort(list);
    list.erase(std::unique(list.begin(), list.end()), list.end());
}
/// Adds an item to a sorted list that lacks it, or removes it from one that has it.
template <class T>
void set_listed(std::vector<T>& sorted, const T& item, bool listed) {
    const auto at = std::ranges::lower_bound(sorted, item);
    const bool was = at != sorted.end() && *at == item;
    if (listed && !was) sorted.insert(at, item);
    if (!listed && was) sorted.erase(at);
}

/// s, after `time`: when a launcher looks again whether its place is free.
[[nodiscard]] double next_look(double time);

class Table {
  public:
    explicit Table(std::shared_ptr<const Scene> scene);

    [[nodiscard]] const Scene& scene() const { return *scene_; }
    [[nodiscard]] double time() const { return state_.clock.time; }
    [[nodiscard]] const Clock& clock() const { return state_.clock; }
    [[nodiscard]] std::span<const PartState> parts() const { return state_.parts; }

    /// Everything but nudges, which move balls and so are the engine's. Launches are queued.
    void apply(const Control& control);

    /// Pose and rate (rad/s) of a part `ahead` seconds from now if no control changes until then. At the
    /// instant a flipper reaches its stop its rate is 0.
    [[nodiscard]] Pose pose(PartIndex part, double ahead = 0) const;
    [[nodiscard]] double rate(PartIndex part, double ahead = 0) const;
    /// Seconds until the rate of a part changes by itself (a flipper reaches its stop); infinity if never.
    [[nodiscard]] double until_stop(PartIndex part) const;
    /// All of these at once.
    struct Turning {
        Pose pose;
        double rate = 0, until_stop = 0;
    };
    [[nodiscard]] Turning turning(PartIndex part, double ahead) const;
    [[nodiscard]] static bool moves(const Part& part) {
        return !std::holds_alternative<motion::Still>(part.motion);
    }
    /// The parts that can move, in order.
    [[nodiscard]] std::span<const PartIndex> moving_parts() const { return moving_; }
    /// Moves the clock and the parts.
    void advance(double dt);
    /// Sets the clock, and the parts as they are `ahead` seconds after `start` if no control changes. What
    /// the engine keeps counts at that time.
    void set_to(const Clock& clock, std::span<const PartState> start, double ahead);

    void set_open(PartIndex gate, bool open) { state_.parts[gate].open = open; }
    /// Whether a closed gate blocks the ball, which is within a radius of it.
    [[nodiscard]] bool is_blocked(PartIndex gate, BallNumber ball) const;
    void set_blocked(PartIndex gate, BallNumber ball, bool blocked);
    /// Whether a gate lets a ball through that touches it, by the rule of gate.hpp, in this pose and at this
    /// rate (rad/s).
    [[nodiscard]] bool lets_through(PartIndex gate, const Pose& pose, double rate, const Ball& ball) const;
    /// Whether a ball that the gate does not block is deep in it: it is on its way through (gate.hpp).
    [[nodiscard]] bool is_deep_in(PartIndex gate, const Pose& pose, const Ball& ball) const;
    /// By gate, then ball.
    [[nodiscard]] std::vector<Blocked>& blocked() { return state_.blocked; }
    [[nodiscard]] const std::vector<Blocked>& blocked() const { return state_.blocked; }
    void set_down(PartIndex target, bool down) { state_.parts[target].down = down; }

    /// The ball with a number of its own, for an engine to add. Throws Refusal where no number is left.
    [[nodiscard]] Ball numbered(Ball ball);
    [[nodiscard]] std::vector<BallNumber>& reported_lost() { return state_.reported_lost; }
    /// Adds an event for each ball that has left the bounds. The engine is to remove it, or if the scene
    /// keeps it, this notes that it was reported.
    void report_lost(std::span<const Ball> balls, std::vector<Event>& events);
    /// Engines that keep one are to name themselves and the time in it after each step.
    [[nodiscard]] EngineMemory& memory() { return state_.memory; }

    /// The next launch if one is waiting and its place is free, given the balls in the world. Either a
    /// new ball to add (number not set yet) or, on a plunger, one that lies there already, with its new
    /// velocity. Call it at the start of a step until it returns nothing. The launcher looks at once when
    /// launches begin to wait, and from then on at next_look(): so often, however long the steps are.
    struct Launched {
        Ball ball;
        bool existing = false;
    };
    std::optional<Launched> launch(std::span<const Ball> balls);
    [[nodiscard]] bool launch_waiting() const { return !state_.launches.empty(); }
    /// Sets when the launcher looks next, s.
    void look_at(double time) { state_.next_look = time; }

    [[nodiscard]] State save(std::span<const Ball> balls) const;
    /// Removes what a state says of balls that are not in it and of gates that are open, and a memory of
    /// another time.
    static void forget_gone(State& state);
    /// Copies the state without its balls; reuses the capacity of `state`.
    void copy(State& state) const { state = state_; }
    /// All of the state but its balls.
    void restore(const State& state);

  private:
    /// Motion of a part, copied from the scene for speed.
    struct Drive {
        Vec2 pivot;
        bool flips = false;
        bool always = false;             ///< turns even while rotate is off
        int side = 0;                    ///< of a flipper, Side
        double full = 0;                 ///< rad from rest to raised
        double rate = 0, down_rate = 0;  ///< rad/s; of a flipper up and down
    };

    std::shared_ptr<const Scene> scene_;
    std::vector<PartIndex> moving_;
    std::vector<Drive> drives_;            ///< of moving_
    std::vector<std::uint32_t> drive_of_;  ///< per part, index into drives_; nothing for static parts
    State state_;                          ///< without balls
};

}  // namespace flipside

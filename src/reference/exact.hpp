#pragma once
/// The exact simulation, whatever numbers it computes with.

#include <chrono>
#include <memory>
#include <span>
#include <vector>

#include "reference/certificate.hpp"
#include "world/controls.hpp"
#include "world/events.hpp"
#include "world/state.hpp"
#include "world/trace.hpp"

namespace flipside::reference {

struct Counts {
    std::uint64_t pair_tests = 0;    ///< things looked at because they are listed near
    std::uint64_t narrow_tests = 0;  ///< searches for a time of touch
    std::uint64_t events = 0;
    std::uint64_t impacts = 0;
    std::uint64_t grazing = 0;  ///< touches too close to call, decided in a wider type
};

/// What a ball will do next, for those who want to see it.
struct Forecast {
    double radius = 0;           ///< m
    bool touches = false;        ///< it ends in a touch
    std::array<Vec2, 17> way{};  ///< from now to its next event
};

class Exact {
  public:
    virtual ~Exact() = default;

    /// Everything anew from a state.
    virtual void load(const State& state) = 0;
    /// All controls but launches.
    virtual void apply(const Control& control) = 0;
    virtual void add(const Ball& ball) = 0;
    virtual void remove(BallNumber number) = 0;
    virtual void set_velocity(BallNumber number, Vec2 velocity) = 0;
    /// Sets the end of the next run, that many seconds from now.
    virtual void begin(double seconds) = 0;
    /// Handles events until the run has ended (true), or, after one at least, until the deadline has passed.
    /// Throws Refusal; what is left then is good for nothing but load().
    [[nodiscard]] virtual bool go_on(std::chrono::steady_clock::time_point deadline) = 0;

    /// From the next run on, each writes its paths and events there; null: nowhere.
    virtual void write_to(Trace* trace) = 0;

    /// From now on writes there how every ball moves and why; null: nowhere any more. Nothing is closed.
    virtual void certify(Certificate* certificate) = 0;

    /// By rising number.
    virtual void read(std::vector<Ball>& balls) const = 0;
    /// Of the last run, in order; times are since its start.
    [[nodiscard]] virtual std::span<const Event> events() const = 0;
    [[nodiscard]] virtual bool open(PartIndex gate) const = 0;
    [[nodiscard]] virtual bool down(PartIndex target) const = 0;
    /// By gate, then ball.
    virtual void blocked(std::vector<Blocked>& blocked) const = 0;
    [[nodiscard]] virtual std::span<const BallNumber> reported_lost() const = 0;
    /// Of the last run.
    [[nodiscard]] virtual const Counts& counts() const = 0;
    /// Between a ball here and a place, m; infinite if there is no such ball.
    [[nodiscard]] virtual double distance(BallNumber number, Vec2 place) const = 0;
    /// Touching pairs now, by ball, then other.
    virtual void contacts(std::vector<Contact>& contacts) const = 0;
    virtual void forecast(std::vector<Forecast>& forecasts) const = 0;
    /// Boxes and numbers of balls of the cells that hold any.
    virtual void occupied(std::vector<std::pair<Box, int>>& cells) const = 0;
};

/// Empty until load(). `bits` of precision: 53, 113 or 226.
[[nodiscard]] std::unique_ptr<Exact> make_exact(int bits, std::shared_ptr<const Scene> scene);

}  // namespace flipside::reference

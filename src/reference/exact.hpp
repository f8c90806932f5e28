#pragma once
/// The interface of the exact simulation, independent of its number type.

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
    std::uint64_t pair_tests = 0;    ///< candidates from the cells
    std::uint64_t narrow_tests = 0;  ///< searches for a time of impact
    std::uint64_t events = 0;
    std::uint64_t impacts = 0;
    std::uint64_t grazing = 0;  ///< grazing contacts that were decided in a wider type
};

/// The next event of a ball, for the window.
struct Forecast {
    double radius = 0;           ///< m
    bool touches = false;        ///< whether the event is an impact
    std::array<Vec2, 17> way{};  ///< from now to its next event
};

class Exact {
  public:
    virtual ~Exact() = default;

    /// Replaces everything by a state.
    virtual void load(const State& state) = 0;
    /// All controls but launches.
    virtual void apply(const Control& control) = 0;
    virtual void add(const Ball& ball) = 0;
    virtual void remove(BallNumber number) = 0;
    virtual void set_velocity(BallNumber number, Vec2 velocity) = 0;
    /// Sets the end of the next run, that many seconds from now.
    virtual void begin(double seconds) = 0;
    /// Handles events until the run has ended (returns true), or until the deadline has passed, but at least
    /// one. May throw Refusal; then only load() may follow.
    [[nodiscard]] virtual bool run_until(std::chrono::steady_clock::time_point deadline) = 0;

    /// Each following run writes its paths and events to the trace; null stops that.
    virtual void write_to(Trace* trace) = 0;

    /// Records all motion to the certificate from now on; null stops that, without closing the certificate.
    virtual void certify(Certificate* certificate) = 0;

    /// By rising number.
    virtual void read(std::vector<Ball>& balls) const = 0;
    /// Events of the last run, in order; times are relative to its start.
    [[nodiscard]] virtual std::span<const Event> events() const = 0;
    [[nodiscard]] virtual bool open(PartIndex gate) const = 0;
    [[nodiscard]] virtual bool down(PartIndex target) const = 0;
    /// By gate, then ball.
    virtual void blocked(std::vector<Blocked>& blocked) const = 0;
    [[nodiscard]] virtual std::span<const BallNumber> reported_lost() const = 0;
    /// Of the last run.
    [[nodiscard]] virtual const Counts& counts() const = 0;
    /// Distance of a ball from a position, m; infinite if there is no such ball.
    [[nodiscard]] virtual double distance(BallNumber number, Vec2 position) const = 0;
    /// Touching pairs now, by ball, then other.
    virtual void contacts(std::vector<Contact>& contacts) const = 0;
    virtual void forecast(std::vector<Forecast>& forecasts) const = 0;
    /// Boxes and numbers of balls of the cells that contain any.
    virtual void occupied(std::vector<std::pair<Box, int>>& cells) const = 0;
};

/// Empty until load(). `bits` of precision: 53, 113 or 226.
[[nodiscard]] std::unique_ptr<Exact> make_exact(int bits, std::shared_ptr<const Scene> scene);

}  // namespace flipside::reference

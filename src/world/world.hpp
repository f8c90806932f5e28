#pragma once
/// The one interface behind which every engine runs. Data is handed over in bulk, never by one virtual
/// call per ball.
///
/// A world is made from a scene and settings (engine.hpp) and both stay as they are for its life: to
/// change a setting, gravity or the engine, make another world and restore this one's state into it.

#include <span>

#include "world/controls.hpp"
#include "world/events.hpp"
#include "world/inspector.hpp"
#include "world/state.hpp"
#include "world/statistics.hpp"
#include "world/trace.hpp"

namespace flipside {

class World {
  public:
    virtual ~World() = default;

    /// Advances by exactly dt seconds (finite, > 0). Sub-steps are the engine's own business.
    /// An engine that cannot do that as exactly as it promises throws Refusal (refusal.hpp).
    virtual void step(double dt) = 0;
    /// The same step, in portions, so that the caller can react: works for about `seconds` of wall time and
    /// is true once the step is done. Until then it is to be called again with the same dt, or the world
    /// given up or restored; balls and all else read as before the step. However it is portioned, the outcome
    /// is the same. Engines whose steps are short do them at once.
    [[nodiscard]] virtual bool step_within(double dt, double seconds) {
        static_cast<void>(seconds);
        step(dt);
        return true;
    }
    /// Takes effect now, at time().
    virtual void apply(const Control& control) = 0;
    /// Adds a ball (its number is ignored) and returns its number.
    virtual BallNumber add(const Ball& ball) = 0;
    /// False when there is no such ball.
    virtual bool remove(BallNumber number) = 0;

    [[nodiscard]] virtual Clock clock() const = 0;
    [[nodiscard]] double time() const { return clock().time; }
    /// Whether balls wait for a free place in the launcher. It looks for one at the start of a step, if its
    /// next look (table.hpp) is due then.
    [[nodiscard]] virtual bool launch_waiting() const { return false; }
    /// By rising number. Valid until the next call that changes the world.
    [[nodiscard]] virtual std::span<const Ball> balls() const = 0;
    /// One per part of the scene, in its order.
    [[nodiscard]] virtual std::span<const PartState> parts() const = 0;
    /// Of the last step, in order of time.
    [[nodiscard]] virtual std::span<const Event> events() const = 0;
    /// Touching pairs at this instant, sensors left out, by ball, then other.
    [[nodiscard]] virtual std::span<const Contact> contacts() const = 0;
    [[nodiscard]] virtual const Statistics& statistics() const = 0;

    /// Per ball of balls(), the error of its position that the engine does not exceed by its own account, m;
    /// infinite where it claims nothing any more. Empty for engines that claim nothing at all.
    [[nodiscard]] virtual std::span<const double> uncertainty() const { return {}; }

    [[nodiscard]] virtual State save() const = 0;
    /// The state must come from a world of the same scene (checked where states enter, state_file.hpp).
    virtual void restore(const State& state) = 0;
    virtual void inspect(Inspector& inspector) const = 0;

    /// From the next step on each writes what it does into `trace`, in place of what is there; null: none
    /// does. Tracing changes no bit of the outcome. The world keeps the pointer.
    virtual void trace(Trace* trace) = 0;
};

}  // namespace flipside

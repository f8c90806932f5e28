#pragma once
/// Runs a session along a timeline, with a callback after each step.

#include <functional>
#include <span>

#include "lab/process/failure.hpp"
#include "lab/session/session.hpp"
#include "lab/session/timeline.hpp"

namespace flipside::lab {

/// Called with the session after a step and with the time of that moment: exactly the timeline's end after
/// the last step.
using Watcher = std::function<void(const Session& session, std::uint64_t step, double time)>;

/// A ball has a position, velocity, angle or spin that is no number.
struct NotANumber : Failure {
    using Failure::Failure;
};
/// Throws NotANumber that names the ball and the time.
void check_finite(const Session& session, double time);

/// Steps all sessions side by side, each by the same script; `after` is called for every session after each
/// step. Throws NotANumber as soon as there is one.
void run(std::span<Session> sessions, const Timeline& timeline, const Script& script, const Watcher& after);

/// The same for one session that is under way: `next` is the index of the script's next control and is moved
/// on. Of the timeline only its steps count.
void run_on(Session& session, const Timeline& steps, const Script& script, std::size_t& next,
            const Watcher& after);

/// Balls whose centre is that of another one, to 1e-6 of a radius: the toy's "overlaps". Cost O(n log n).
[[nodiscard]] std::uint64_t overlaps(std::span<const Ball> balls);

}  // namespace flipside::lab

#pragma once
/// The trace of one step of a session: made, narrowed down to a ball, and written as text and JSON.

#include <optional>
#include <string>

#include "lab/session/session.hpp"
#include "world/trace.hpp"

namespace flipside::lab {

/// A step, looked into.
struct TracedStep {
    std::string scene, engine;
    double time = 0;  ///< s, at which it begins
    double dt = 0;    ///< s
    Trace trace;
};

/// Makes the session's next step, with the script's controls in it (`next` as in Session::step), and writes
/// down what its world does. A step that a control splits is traced from the last control on.
[[nodiscard]] TracedStep trace_step(Session& session, double dt, const Script& script, std::size_t& next);

/// Leaves out what is about other balls only.
void keep_ball(Trace& trace, BallNumber ball);

/// A line for each stage and each item. What comes from files is printable().
[[nodiscard]] std::string to_text(const TracedStep& step);
/// As assets/trace.schema.json describes it; numbers to the last digit.
[[nodiscard]] std::string to_json(const TracedStep& step);

}  // namespace flipside::lab

#pragma once
/// The trace of a step of the continuous solver: the paths and predictions at its start, then the events in
/// order of time, interrupted by the island solves at the ticks. All functions need a trace in the record of
/// the step.

#include <functional>
#include <span>

#include "custom/continuous/simulation.hpp"
#include "custom/islands/contact_solver.hpp"

namespace flipside::custom {

/// Writes the path of every ball and its next event.
void trace_paths(const Simulation& sim, bool all_start);
/// Handles the next event of a ball by `handle`, and writes it with its result.
void trace_event(const Simulation& sim, BallIndex i, const std::function<void()>& handle);
/// Writes the contacts, sweeps and members of the last island solve.
void trace_tick(const Simulation& sim, const ContactSolver& solver, std::span<const BallIndex> members,
                double time, double duration);

}  // namespace flipside::custom

#pragma once
/// The subcommands. Each adds itself to the program and, when it is chosen, sets what to do once the whole
/// command line has been read.

#include <functional>

#include <CLI/CLI.hpp>

namespace flipside::app {

/// Does the work; returns the exit code. Throws InputError (exit 2) or another exception (exit 1).
using Action = std::function<int()>;

void add_play(CLI::App& program, Action& chosen);
void add_run(CLI::App& program, Action& chosen);
void add_bot(CLI::App& program, Action& chosen);
void add_compare(CLI::App& program, Action& chosen);
void add_certify(CLI::App& program, Action& chosen);
void add_trace(CLI::App& program, Action& chosen);
void add_lessons(CLI::App& program, Action& chosen);
void add_cases(CLI::App& program, Action& chosen);
void add_pairs(CLI::App& program, Action& chosen);
void add_sweep(CLI::App& program, Action& chosen);
void add_hunt(CLI::App& program, Action& chosen);
void add_report(CLI::App& program, Action& chosen);
void add_replay(CLI::App& program, Action& chosen);
void add_render(CLI::App& program, Action& chosen);
void add_scenes(CLI::App& program, Action& chosen);
void add_engines(CLI::App& program, Action& chosen);
void add_check(CLI::App& program, Action& chosen);
void add_conformance(CLI::App& program, Action& chosen);
/// `released` is the date that the page bears, as 2026-11-24.
void add_manual(CLI::App& program, const std::string& released, Action& chosen);
void add_completion(CLI::App& program, Action& chosen);

}  // namespace flipside::app

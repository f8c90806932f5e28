#pragma once
/// Cost and results of the last step.

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace flipside {

struct StageTime {
    std::string_view name;  ///< as the engine calls this stage of its step
    double seconds = 0;
};

/// Facts about the broad phase; zero where they do not apply.
struct BroadPhaseFacts {
    std::string_view name;  ///< empty: the engine does not say
    int levels = 0;
    int nodes = 0;
    int leaves = 0;
    double leaf_width = 0, leaf_height = 0;  ///< m
    int most_in_leaf = 0;
};

struct Statistics {
    std::string_view solver;         ///< the one that made the step; empty where there is only one
    bool event_ordered = false;      ///< impacts were found at their exact times and handled in that order
    std::uint64_t pair_tests = 0;    ///< tests of one box against another, insertion included
    bool counts_pair_tests = true;   ///< whether the engine counts these; a library may not say
    std::uint64_t narrow_tests = 0;  ///< tests of one shape against another
    std::uint64_t contacts = 0;      ///< pairs found in touch, counted once per collision iteration
    std::uint64_t impacts = 0;       ///< impact events
    std::uint64_t substeps = 0;
    std::uint64_t asleep = 0;           ///< balls asleep at the end of the step
    std::uint64_t handed_over = 0;      ///< balls in contact islands, which are solved at ticks
    std::uint64_t grazing = 0;          ///< touches too close to call, decided in a wider type
    std::array<StageTime, 8> stages{};  ///< in order; unused ones have an empty name
    BroadPhaseFacts broad_phase;
    /// CPU time of the step, s, where it was made in another process, of which the caller's clock sees
    /// nothing.
    std::optional<double> cpu_seconds;
};

}  // namespace flipside

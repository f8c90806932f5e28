#pragma once
/// The figures of a run, as stats.json holds them.

#include <string>

#include "lab/session/session.hpp"

namespace flipside::lab {

struct RunFigures {
    Totals totals;
    std::size_t balls = 0;  ///< in the world at the end
    std::uint64_t asleep = 0;
    std::uint64_t overlaps = 0;
    double sim_seconds = 0;
    double energy_first = 0, energy_last = 0;  ///< J
    long score = 0;
};

[[nodiscard]] RunFigures figures_of(const Session& session, double sim_seconds, double energy_first);
/// One JSON object, the figures by name.
[[nodiscard]] std::string to_json(const RunFigures& figures);

}  // namespace flipside::lab

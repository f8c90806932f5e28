#pragma once
/// How much a report measures.

#include <cstddef>
#include <vector>

namespace flipside::lab::report {

struct Effort {
    const char* name;             ///< data of one effort do not mix with those of another
    double pair_seconds;          ///< simulated, of the toy's experiment, for each number of balls
    std::size_t most_pair_balls;  ///< in the growth of broad phases
    int gas_balls;
    double energy_seconds;
    double divergence_seconds;
    int rain_balls;  ///< of the penetration
    double rain_seconds;
    std::vector<int> growth_balls;  ///< rain with these numbers of balls
    double growth_seconds;          ///< simulated, for each of them
    double growth_limit;            ///< CPU seconds after which such a run is given up
};

[[nodiscard]] inline Effort full_effort() {
    return {"full", 60, 100'000, 200, 6, 10, 300, 5, {100, 320, 1000, 3200, 10'000, 32'000, 100'000}, 1, 15};
}
[[nodiscard]] inline Effort quick_effort() {
    return {"quick", 10, 32'000, 100, 3, 5, 100, 3, {100, 320, 1000, 3200}, 0.5, 3};
}

}  // namespace flipside::lab::report

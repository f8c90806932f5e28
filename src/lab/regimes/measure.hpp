#pragma once
/// Speed by regime: all kinds run a course in one process, a slice of simulated time in turn, so that what
/// else the machine does meets all alike; as often for each. Their order is shuffled for every slice: who
/// runs after a kind with the same code finds it in the caches, which is worth up to 130 ns per ball and
/// step on the pinball table.

#include <functional>
#include <optional>
#include <span>

#include "lab/regimes/contender.hpp"
#include "lab/regimes/courses.hpp"

namespace flipside::lab::regimes {

/// One kind in one regime.
struct Result {
    std::string regime;
    int balls = 0;
    bool is_kind = false;  ///< as Regime has it
    Kind kind;
    std::string failure;              ///< "" or why it did not run to the end
    std::vector<double> nanoseconds;  ///< CPU time per ball and step, of each repeat
    double own = 0;                   ///< the least time by the engine's own account, ns; 0: it tells nothing
    /// How far the worst ball is from where the reference has it, a tenth of a second after the state at the
    /// regime's beginning, radii; none where the reference refuses.
    std::optional<double> error;
    double deepest = 0;           ///< overlap at the end of any slice, radii
    std::optional<double> drift;  ///< of the energy, relative; where nothing should change it
    std::size_t lost = 0;         ///< balls
};

struct Measuring {
    int repeats = 3;
    bool with_errors = true;
    std::function<void(double share)> watch{};  ///< called often; may throw to stop
};
/// By regime, in the order of the course; in each by kind. A kind that cannot run the course says why.
[[nodiscard]] std::vector<Result> measure(const Course& course, std::span<const Kind> taking_part,
                                          const Measuring& how);
inline constexpr int slice_steps = 15;

}  // namespace flipside::lab::regimes

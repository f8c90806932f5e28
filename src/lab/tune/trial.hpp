#pragma once
/// Settings on trial: what they cost and how far from the truth they are, on windows (sweep/windows.hpp) that
/// no sweep measures on.

#include <functional>
#include <limits>

#include "lab/contenders/contender.hpp"
#include "lab/sweep/windows.hpp"

namespace flipside::lab::tune {

struct Score {
    /// Radii: position of the worst ball at the end of a window, median over the windows. Infinite where half
    /// of them failed.
    double error = std::numeric_limits<double>::infinity();
    /// CPU seconds per simulated second, the least of `repeats` in each timed window.
    double cost = std::numeric_limits<double>::infinity();
};
inline constexpr std::size_t repeats = 3, timed = 5;

/// The windows of one variant that trials run.
class Trials {
  public:
    /// Blocks of sweeps count from 0; these far above them, so that nothing is tuned on what it is judged by.
    static constexpr std::uint32_t search_block = 1'000'000, check_block = 2'000'000;

    /// `windows` of a variant; fewer where its trajectories do not give more. Throws InputError where they
    /// give none. `watch` is called often and may throw to stop.
    Trials(const sweep::Variant& variant, std::uint64_t seed, std::uint32_t block, std::size_t windows,
           const std::function<void()>& watch);

    [[nodiscard]] const Scene& scene() const { return *scene_; }
    /// See Score.
    [[nodiscard]] double error(const Contender& contender) const;
    /// Both figures; some `timed` windows are timed. Infinite where the engine
    /// cannot run the scene, and for what is given up: once it has cost more than twice `most_cost` on the
    /// windows until then, or once more than half of all windows have an error above `most_error`.
    [[nodiscard]] Score score(const Contender& contender, double most_error, double most_cost) const;
    /// CPU seconds per simulated second of each contender in each window, the least of `repeats` rounds in
    /// which they take turns. Not a number where one failed.
    [[nodiscard]] std::vector<std::vector<double>> times(std::span<const Contender> contenders) const;

  private:
    [[nodiscard]] double median_error(World& world, double dt, double most_error, double most_cost) const;

    std::shared_ptr<const Scene> scene_;
    sweep::Block block_;
    std::function<void()> watch_;
};

}  // namespace flipside::lab::tune

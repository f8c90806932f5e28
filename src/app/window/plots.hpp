#pragma once
/// What the window plots over time: how far the contenders are apart, their energy, what a step costs, how
/// many tests it makes.

#include <string_view>
#include <vector>

#include "app/window/plot.hpp"
#include "app/window/stage.hpp"

namespace flipside::app {

/// Which plots stand in the strip. The key for the next one goes through them in this order.
enum class PlotChoice { distance_and_energy, all, distance, energy, cost, tests };
inline constexpr int plot_choices = 6;
[[nodiscard]] std::string_view name_of(PlotChoice choice);

/// From the reference, where it takes part; else of the others from the first.
[[nodiscard]] Plot distance_plot(const Stage& stage);
[[nodiscard]] Plot energy_plot(const Stage& stage);
/// CPU time per step; of a contender that is alone, also of each of its stages.
[[nodiscard]] Plot cost_plot(const Stage& stage);
/// Tests of boxes per step; none of a contender that does not count them.
[[nodiscard]] Plot tests_plot(const Stage& stage);
[[nodiscard]] std::vector<Plot> plots_of(PlotChoice choice, const Stage& stage);

}  // namespace flipside::app

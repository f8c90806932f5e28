#pragma once
/// What the window plots over time: how far the contenders are apart, their energy, what a step costs, how
/// many tests it makes.

#include <iterator>
#include <string_view>
#include <vector>

#include "app/window/plot.hpp"
#include "app/window/stage.hpp"

namespace flipside::app {

/// Which plots stand in the strip. The key for the next one goes through them in this order.
enum class PlotChoice {
    distance_and_energy,
    distance_and_cost,
    tests_and_cost,
    all,
    distance,
    energy,
    cost,
    tests
};
struct PlotSpec {
    PlotChoice choice;
    std::string_view name;   ///< in files
    std::string_view label;  ///< in the window
};
inline constexpr PlotSpec plot_specs[] = {
    {PlotChoice::distance_and_energy, "distance-and-energy", "Distance and energy"},
    {PlotChoice::distance_and_cost, "distance-and-cost", "Distance and cost"},
    {PlotChoice::tests_and_cost, "tests-and-cost", "Tests and cost"},
    {PlotChoice::all, "all", "All four"},
    {PlotChoice::distance, "distance", "Distance"},
    {PlotChoice::energy, "energy", "Energy"},
    {PlotChoice::cost, "cost", "Cost per step"},
    {PlotChoice::tests, "tests", "Tests per step"}};
[[nodiscard]] constexpr const PlotSpec& spec_of(PlotChoice choice) {
    return plot_specs[static_cast<int>(choice)];
}
[[nodiscard]] constexpr PlotChoice after(PlotChoice choice) {
    return plot_specs[(static_cast<std::size_t>(choice) + 1) % std::size(plot_specs)].choice;
}
/// The one of that name in files. There must be one.
[[nodiscard]] PlotChoice plots_named(std::string_view name);

/// From the reference, where it takes part; else of the others from the first.
[[nodiscard]] Plot distance_plot(const Stage& stage);
[[nodiscard]] Plot energy_plot(const Stage& stage);
/// CPU time per step or, where their steps differ in length, per simulated second; of a contender that is
/// alone, also of each of its stages.
[[nodiscard]] Plot cost_plot(const Stage& stage);
/// Tests of boxes per step; none of a contender that does not count them.
[[nodiscard]] Plot tests_plot(const Stage& stage);
[[nodiscard]] std::vector<Plot> plots_of(PlotChoice choice, const Stage& stage);

}  // namespace flipside::app

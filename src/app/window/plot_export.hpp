#pragma once
/// The numbers of all runs on show as CSV: what the plots are drawn from.

#include <ostream>

#include "app/window/stage.hpp"

namespace flipside::app {

/// A row per contender and recorded step, by contender, then time. Times in s, energy in J, overlaps in m,
/// distances in radii; a field that the engine does not count, or that has no value then, is empty. The
/// stages of a step are written as "name seconds; name seconds".
void write_numbers(std::ostream& out, const Stage& stage);

}  // namespace flipside::app

#pragma once
/// What a lesson claims and what was measured for it, as people say it: files have names for computing.

#include <string>
#include <string_view>
#include <vector>

#include "lab/lessons/claim.hpp"

namespace flipside::app {

/// "one_step.pair_tests == 2 * 25" as "box tests (one step) = 2 × 25"; of a lesson with one run only
/// (`one_run`) as "box tests = 2 × 25".
[[nodiscard]] std::string claim_in_words(std::string_view statement, bool one_run);
/// The figures in a statement that does not give them itself.
[[nodiscard]] std::vector<std::string> measured_in_words(const lab::Verified& one, bool one_run);

}  // namespace flipside::app

#pragma once
/// What a sweep advises: its rows and sentences on the front page.

#include <string>
#include <vector>

#include "lab/report/best_settings.hpp"
#include "lab/report/page.hpp"

namespace flipside::lab::report {

/// The kind of scene that a variant is: "pinball, 8 balls".
[[nodiscard]] std::string kind_of(const std::string& variant);
[[nodiscard]] Pick pick_of(const std::vector<sweep::Figures>& all, const Best& best);
[[nodiscard]] std::vector<std::string> findings_of(const std::vector<sweep::Figures>& all,
                                                   std::span<const Best> best);

}  // namespace flipside::lab::report

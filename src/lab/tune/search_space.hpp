#pragma once
/// The values of a setting that a search tries.

#include <string>
#include <vector>

#include "world/settings.hpp"

namespace flipside::lab::tune {

/// As texts, its default among them: both of a toggle, all of a choice; of a number those that differ from
/// its default by powers of two (integers) or of ten to the half (reals), six to either side at most; where
/// the default is 0 (as of what the engine finds by itself), powers of ten to the half over the allowed
/// range, nine decades at most.
[[nodiscard]] std::vector<std::string> candidates_of(const SettingSpec& spec);

}  // namespace flipside::lab::tune

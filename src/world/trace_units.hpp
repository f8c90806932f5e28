#pragma once
/// The units of what traces tell: a field of one name has one unit in the traces of all engines.

#include <string>
#include <string_view>

#include "world/trace.hpp"

namespace flipside {

/// "" where it has none, as normals, counts and names.
[[nodiscard]] std::string_view unit_of(std::string_view field, const TraceValue& value);
/// As in_brief(), with the unit.
[[nodiscard]] std::string with_its_unit(std::string_view field, const TraceValue& value);

}  // namespace flipside

#pragma once
/// Counts what this program allocates.

#include <cstddef>

namespace flipside::custom::test {

/// Calls of operator new since the start.
[[nodiscard]] std::size_t allocations();

}  // namespace flipside::custom::test

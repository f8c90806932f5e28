#pragma once
/// Counts allocations, to show that steps make none.

#include <cstdint>

namespace flipside::lab {

/// Calls of operator new by all threads since the program started. C code that calls malloc itself (as
/// Box2D's block allocator does) is not seen.
[[nodiscard]] std::uint64_t allocations();

}  // namespace flipside::lab

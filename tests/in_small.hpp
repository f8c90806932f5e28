#pragma once
/// The sanitizers look for wrong accesses, not for wrong figures, and make everything ten times slower.

namespace flipside::test {

/// Under them, what takes long is done in small.
#ifdef FLIPSIDE_SANITIZED
inline constexpr bool in_small = true;
#else
inline constexpr bool in_small = false;
#endif

}  // namespace flipside::test

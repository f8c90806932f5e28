#pragma once
/// The commit that the build was configured at.

#include <string>

namespace flipside::lab {

/// "unknown" outside git.
[[nodiscard]] std::string build_commit();

}  // namespace flipside::lab

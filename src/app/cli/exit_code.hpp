#pragma once
/// How the program ends.

#include <functional>

namespace flipside::app {

/// Does it and finishes the output. Returns its exit code, or what it throws as one, with one line on stderr:
/// 2 for InputError and paths that cannot be used, 1 for everything else, also where there is no memory.
int exit_code_of(const std::function<int()>& action) noexcept;

}  // namespace flipside::app

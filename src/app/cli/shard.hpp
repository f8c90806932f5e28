#pragma once
/// --shard K/N, of commands whose work can be split.

#include <string>

#include "lab/sweep/sweep.hpp"

namespace flipside::app {

/// Throws InputError for what is no K/N with 1 ≤ K ≤ N ≤ 1,000,000.
[[nodiscard]] lab::sweep::Shard parse_shard(const std::string& text);

}  // namespace flipside::app

#pragma once
/// `flipside sweep --tune ENGINE`: a search for its best settings in place of a sweep.

#include <filesystem>
#include <span>

#include "lab/tune/tune.hpp"

namespace flipside::app {

/// Searches on each variant, prints what it found, and writes FOLDER/tuning.csv. Returns the exit code.
int run_tuning(const lab::tune::Request& request, std::span<const lab::sweep::Variant> variants,
               const std::filesystem::path& folder);

}  // namespace flipside::app

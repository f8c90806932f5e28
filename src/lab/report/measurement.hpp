#pragma once
/// The measurements of a report. Each has a file of its own, whole or not there at all; what is there is not
/// measured again, so a report that was stopped goes on where it was.

#include <filesystem>
#include <functional>
#include <span>
#include <string>

namespace flipside::lab::report {

/// Told how much of the work is done, 0 … 1; may throw to stop it.
using Watch = std::function<void(double share)>;

struct Measurement {
    std::string file;    ///< its name in the folder of data
    double seconds = 1;  ///< CPU time it takes, about: for the progress
    std::function<void(const std::filesystem::path& file, const Watch& watch)> take;
};

/// Takes those whose file is not there, in their order.
void take(std::span<const Measurement> measurements, const std::filesystem::path& folder, const Watch& watch);

}  // namespace flipside::lab::report

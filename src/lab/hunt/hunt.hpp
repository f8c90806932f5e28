#pragma once
/// A hunt in a folder:
///
///     plan.txt          what is hunted (plan_of); a folder holds one hunt
///     rounds/NNN.txt    what a round found: its scene file (data_file.hpp)
///     worst.json        the scene file of the worst of them, once all rounds are there
///     rounds.csv        a row per round: how bad, when, what
///
/// Rounds may be made in any order, by any number of processes at once; what is finished is not made again,
/// and what is damaged is. The same request gives the same bytes, however it was split up.

#include <filesystem>
#include <optional>

#include "lab/files/data_file.hpp"
#include "lab/hunt/round.hpp"
#include "lab/sweep/sweep.hpp"

namespace flipside::lab::hunt {

/// Everything that decides what a round finds, in a line; the commit of this build is in it. How many rounds
/// there are is not, so a hunt can go on for more of them later.
[[nodiscard]] std::string plan_of(const Request& request);

/// A scene file's name and its sentence of what was found.
[[nodiscard]] std::string titled(const Request& request, const Found& found);
/// "box2d at 0.0167 s: 0.41 radii, ball 0 in part 1, at 0.35 s"
[[nodiscard]] std::string sentence(const Request& request, const Measured& measured);

/// Makes what is missing of the shard's rounds. Then, where all rounds are there, writes worst.json and
/// rounds.csv and returns them, the worst first. Throws InputError where the folder holds another hunt.
/// `watch` is told the share done, and may throw to stop.
[[nodiscard]] std::optional<std::vector<Found>> hunt(const Request& request, sweep::Shard shard,
                                                     const std::filesystem::path& folder,
                                                     const std::function<void(double)>& watch,
                                                     const Notice& notice);

}  // namespace flipside::lab::hunt

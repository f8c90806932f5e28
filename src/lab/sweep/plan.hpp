#pragma once
/// What a sweep measures, as plan.json says it, and its work units.

#include <filesystem>

#include "lab/sweep/contenders.hpp"
#include "lab/sweep/variants.hpp"

namespace flipside::lab::sweep {

/// The largest number up to which a JSON number tells every seed from the next.
inline constexpr std::int64_t largest_seed = 9007199254740991;

/// Plan::most_work where no window is left out.
inline constexpr double unlimited_work = 1e12;

struct Plan {
    std::vector<Variant> variants{};
    std::vector<const Contender*> contenders = all_contenders();
    std::uint64_t seed = 1;       ///< at most largest_seed
    std::uint32_t blocks = 20;    ///< per variant
    std::size_t block_size = 25;  ///< windows
    std::size_t timed = 3;        ///< windows of each block that are timed, and
    std::size_t repetitions = 5;  ///< how often
    int finest = finest_steps;    ///< steps per second at most
    double most_work = 3'000;     ///< balls times steps in a window, above which windows are left out

    [[nodiscard]] std::size_t windows() const { return blocks * block_size; }
};
/// A plan of fewer windows and no step below 1/960 s, for a first look.
[[nodiscard]] Plan quick_plan(std::vector<Variant> variants, std::uint64_t seed);

/// Everything that decides what a sweep measures: the plan, what its contenders are, checksums of its scenes
/// with their scripts, and the commit of this build. Throws InputError for unknown scenes.
[[nodiscard]] std::string to_json(const Plan& plan);
/// The plan of such a text, which another build may have written, where scenes may have differed. Throws
/// InputError for what is none, and for contenders that are not the same here.
[[nodiscard]] Plan parse_plan(std::string_view json, const std::string& file);

/// DIR/plan.json, a data file. The text is that of to_json().
void write_plan(const std::filesystem::path& folder, const std::string& json);
/// Its text. Throws InputError for what is no whole plan.
[[nodiscard]] std::string read_plan(const std::filesystem::path& folder);

/// The step sizes at which a contender is swept, s, the largest first.
[[nodiscard]] std::vector<double> steps_of(const Contender& contender, const Plan& plan);
/// Only every n-th window of a variant is run where many balls take many steps: n is a power of two, such
/// that balls and steps of n windows make no more than n times the plan's most_work.
[[nodiscard]] std::size_t thinning(const Plan& plan, std::size_t balls, double seconds, double dt);

/// A block of a variant's windows.
struct Unit {
    const Variant* variant;
    std::uint32_t block;
};
[[nodiscard]] std::vector<Unit> units_of(const Plan& plan);
/// "pinball-1-003", as its files are called.
[[nodiscard]] std::string name_of(const Unit& unit);
[[nodiscard]] std::filesystem::path windows_file(const Unit& unit, const std::filesystem::path& folder);
[[nodiscard]] std::filesystem::path runs_file(const Unit& unit, const std::filesystem::path& folder);
/// The origin (data_file.hpp) of a unit's file of this kind, "runs" or "windows". `plan` is that of
/// to_json().
[[nodiscard]] std::string origin_of_unit(std::string_view kind, std::string_view plan, const Unit& unit);

}  // namespace flipside::lab::sweep

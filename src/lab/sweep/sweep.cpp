#include "lab/sweep/sweep.hpp"

#include <algorithm>
#include <set>

#include "lab/files/whole_file.hpp"
#include "lab/process/failure.hpp"
#include "lab/sweep/unit.hpp"
#include "lab/sweep/windows.hpp"
#include "world/input_error.hpp"

namespace flipside::lab::sweep {

namespace fs = std::filesystem;

namespace {

using Watch = std::function<void(double)>;

/// A sweep in its folder.
struct Place {
    const Plan& plan;
    const std::string text;  ///< of the plan
    const fs::path& folder;
    const Notice& notice;
    const char* of_damaged;  ///< what becomes of a damaged file
    std::set<std::pair<std::string, std::string>>&
        told;  ///< variants and contenders whose refusals were told
};

BlockPlan block_of(const Plan& plan, const Unit& unit) {
    return {*unit.variant, plan.seed, unit.block, plan.block_size};
}

/// Writes the plan, or sees that the one that is there is the same.
void settle_plan(const Place& place) {
    const auto found = read_back(
        place.folder / "plan.json", place.notice, [&] { return read_plan(place.folder); }, place.of_damaged);
    if (!found) return write_plan(place.folder, place.text);
    if (*found != place.text)
        throw InputError((place.folder / "plan.json").string(), "",
                         "is the plan of another sweep or of another build; allowed is the same one, or an "
                         "empty folder");
}

std::optional<Block> find_block(const Place& place, const Unit& unit, const Scene& scene) {
    const fs::path file = windows_file(unit, place.folder);
    const auto read = [&] {
        const std::string text = read_data_file(file, origin_of_unit("windows", place.text, unit));
        return parse_block(text, file.string(), block_of(place.plan, unit), scene);
    };
    return read_back(file, place.notice, read, place.of_damaged);
}

std::optional<std::vector<Run>> find_runs(const Place& place, const Unit& unit, const Block& block) {
    const fs::path file = runs_file(unit, place.folder);
    const auto read = [&] {
        const std::string text = read_data_file(file, origin_of_unit("runs", place.text, unit));
        auto runs = parse_runs(text, file, place.plan, unit);
        require_all_runs(runs, place.plan, unit, block, file);
        return runs;
    };
    return read_back(file, place.notice, read, place.of_damaged);
}

/// Of each contender, the first run on a variant that could not be made.
void tell_refusals(const Place& place, const std::vector<Run>& runs) {
    for (const Run& run : runs)
        if (!run.outcome.why.empty() && place.told.emplace(run.variant, run.contender).second)
            place.notice(run.variant + ", window " + std::to_string(run.window + 1) + ": " + run.outcome.why);
}

/// Makes what is missing of the two files of a unit.
void make_unit(const Place& place, const Unit& unit, const Watch& watch) {
    const auto scene = load(*unit.variant);
    auto block = find_block(place, unit, *scene);
    if (!block) {
        block = make_block(block_of(place.plan, unit), scene, reference_for(*scene), [&] { watch(0); });
        write_data_file(windows_file(unit, place.folder), origin_of_unit("windows", place.text, unit),
                        to_json(*block, *scene));
    }
    if (find_runs(place, unit, *block)) return;
    const std::vector<Run> runs = measure_unit(place.plan, unit, *block, scene, watch);
    tell_refusals(place, runs);
    write_data_file(runs_file(unit, place.folder), origin_of_unit("runs", place.text, unit), to_csv(runs));
}

/// About how long a unit of a variant takes, in steps of a ball.
double work_of(const Plan& plan, const Variant& variant) {
    const double balls = variant.balls > 0 ? variant.balls : 10;
    const double seconds = 0.5 * window_unit * (variant.shortest + variant.longest);
    constexpr double overhead = 4;  // a step costs about as much as that many balls in it
    double work = 0;
    for (const Contender* contender : plan.contenders)
        for (const double dt : steps_of(*contender, plan))
            work += std::min((overhead + balls) * seconds / dt, plan.most_work);
    return work;
}

}  // namespace

void make_runs(const Plan& plan, Shard shard, const fs::path& folder, const Watch& watch,
               const Notice& notice) {
    std::set<std::pair<std::string, std::string>> told;
    const Place place{plan, to_json(plan), folder, notice, "it is made again", told};
    for (const char* part : {"windows", "runs"}) make_folder(folder / part);
    settle_plan(place);
    std::vector<Unit> units;
    const std::vector<Unit> all = units_of(plan);
    for (std::size_t i = shard.index - 1; i < all.size(); i += shard.count) units.push_back(all[i]);

    double whole = 0, done = 0;
    for (const Unit& unit : units) whole += work_of(plan, *unit.variant);
    for (const Unit& unit : units) {
        const double work = work_of(plan, *unit.variant);
        make_unit(place, unit, [&](double of_unit) { watch((done + of_unit * work) / whole); });
        done += work;
        watch(done / whole);
    }
}

Inventory take_inventory(const Plan& plan, const fs::path& folder) {
    const Notice refuse = [](const std::string& sentence) { throw Failure(sentence); };
    std::set<std::pair<std::string, std::string>> told;
    const Place place{plan, to_json(plan), folder, refuse, "the shard that it belongs to makes it again",
                      told};
    Inventory inventory;
    for (const Unit& unit : units_of(plan)) {
        const auto scene = load(*unit.variant);
        const auto block = find_block(place, unit, *scene);
        inventory.is_complete &= block && find_runs(place, unit, *block);
        if (!block) continue;
        Windows& of_variant = inventory.windows[unit.variant->name];
        of_variant.windows += block->windows.size();
        of_variant.trajectories += block->trajectories;
        for (const auto& [reason, count] : block->skipped) of_variant.skipped[reason] += count;
    }
    return inventory;
}

}  // namespace flipside::lab::sweep

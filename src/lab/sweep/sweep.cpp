#include "lab/sweep/sweep.hpp"

#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

#include "lab/sweep/unit.hpp"
#include "lab/whole_file.hpp"
#include "world/input_error.hpp"
#include "world/json_file.hpp"

namespace flipside::lab::sweep {

namespace fs = std::filesystem;

namespace {

fs::path file_of(const Unit& unit, const fs::path& folder, const char* kind, const char* extension) {
    const std::string number = std::to_string(unit.block + 1);
    const std::string padded = std::string(3 - std::min<std::size_t>(3, number.size()), '0') + number;
    return folder / kind / (unit.variant->name + "-" + padded + extension);
}

fs::path runs_file(const Unit& unit, const fs::path& folder) {
    return file_of(unit, folder, "runs", ".csv");
}

/// Writes the plan, or sees that the one that is there is the same.
void settle_plan(const Plan& plan, const fs::path& folder) {
    const fs::path file = folder / "plan.json";
    if (!fs::exists(file)) {
        write_whole_file(file, to_json(plan));
    } else if (read_file(file) != to_json(plan)) {
        throw InputError(file.string(), "",
                         "is the plan of another sweep; allowed is the same one, or an empty folder");
    }
}

/// The windows of a unit, from their file, which is made first where it is missing.
Block windows_of(const Plan& plan, const Unit& unit, const fs::path& folder,
                 const std::shared_ptr<const Scene>& scene, const std::function<void()>& watch) {
    const fs::path file = file_of(unit, folder, "windows", ".json");
    if (!fs::exists(file)) {
        const BlockPlan block{*unit.variant, plan.seed, unit.block, plan.block_size};
        write_block(file, make_block(block, scene, reference_for(*scene), watch), *scene);
    }
    return read_block(file, *scene);
}

/// About how long a unit of a variant takes, in steps of a ball.
double work_of(const Plan& plan, const Variant& variant) {
    const double balls = variant.balls > 0 ? variant.balls : 10;
    const double seconds = 0.5 * window_unit * (variant.shortest + variant.longest);
    constexpr double overhead = 4;  // a step costs about as much as that many balls in it
    double work = 0;
    for (const Entrant* entrant : plan.entrants)
        for (const double dt : steps_of(*entrant, plan))
            work += std::min((overhead + balls) * seconds / dt, plan.most_work);
    return work;
}

}  // namespace

Plan quick_plan(std::vector<Variant> variants, std::uint64_t seed) {
    Plan plan{.variants = std::move(variants), .seed = seed};
    plan.blocks = 4;
    plan.block_size = 10;
    plan.timed = 2;
    plan.finest = 960;
    plan.most_work = 2'000;
    return plan;
}

std::string to_json(const Plan& plan) {
    nlohmann::ordered_json variants, all;
    for (const Variant& variant : plan.variants)
        variants.push_back({{"name", variant.name},
                            {"scene", variant.scene},
                            {"balls", variant.balls},
                            {"from", variant.from},
                            {"until", variant.until},
                            {"shortest", variant.shortest},
                            {"longest", variant.longest}});
    for (const Entrant* entrant : plan.entrants)
        all.push_back({{"name", entrant->name},
                       {"engine", entrant->engine},
                       {"settings", entrant->settings},
                       {"about", entrant->about}});
    const nlohmann::ordered_json json{{"format", "flipside-sweep/1"},
                                      {"seed", plan.seed},
                                      {"blocks", plan.blocks},
                                      {"windows_per_block", plan.block_size},
                                      {"timed_per_block", plan.timed},
                                      {"repetitions", plan.repetitions},
                                      {"finest_steps_per_second", plan.finest},
                                      {"most_work", plan.most_work},
                                      {"variants", variants},
                                      {"entrants", all}};
    return json.dump(2) + '\n';
}

std::vector<double> steps_of(const Entrant& entrant, const Plan& plan) {
    std::vector<double> steps;
    for (int n = entrant.coarsest; n <= std::min(entrant.finest, plan.finest); n *= 2)
        steps.push_back(1.0 / n);
    return steps;
}

std::size_t thinning(const Plan& plan, std::size_t balls, double seconds, double dt) {
    std::size_t every = 1;
    while (static_cast<double>(balls) * seconds / dt > plan.most_work * static_cast<double>(every))
        every *= 2;
    return every;
}

std::vector<Unit> units_of(const Plan& plan) {
    std::vector<Unit> units;
    for (const Variant& variant : plan.variants)
        for (std::uint32_t block = 0; block < plan.blocks; ++block) units.push_back({&variant, block});
    return units;
}

void make_runs(const Plan& plan, Shard shard, const fs::path& folder,
               const std::function<void(double)>& watch) {
    fs::create_directories(folder / "windows");
    fs::create_directories(folder / "runs");
    settle_plan(plan, folder);
    std::vector<Unit> units;
    const std::vector<Unit> all = units_of(plan);
    for (std::size_t i = shard.index - 1; i < all.size(); i += shard.count) units.push_back(all[i]);

    double whole = 0, done = 0;
    for (const Unit& unit : units) whole += work_of(plan, *unit.variant);
    for (const Unit& unit : units) {
        const double work = work_of(plan, *unit.variant);
        const auto share = [&](double of_unit) { watch((done + of_unit * work) / whole); };
        if (const fs::path file = runs_file(unit, folder); !fs::exists(file)) {
            const auto scene = load(*unit.variant);
            const Block block = windows_of(plan, unit, folder, scene, [&] { share(0); });
            write_runs(file, measure_unit(plan, unit, block, scene, share));
        }
        done += work;
    }
}

bool is_complete(const Plan& plan, const fs::path& folder) {
    const std::vector<Unit> units = units_of(plan);
    return std::ranges::all_of(units, [&](const Unit& unit) { return fs::exists(runs_file(unit, folder)); });
}

}  // namespace flipside::lab::sweep

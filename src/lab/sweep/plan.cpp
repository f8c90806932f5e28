#include "lab/sweep/plan.hpp"

#include <algorithm>

#include "lab/files/data_file.hpp"

namespace flipside::lab::sweep {

namespace fs = std::filesystem;

Plan quick_plan(std::vector<Variant> variants, std::uint64_t seed) {
    Plan plan{.variants = std::move(variants), .seed = seed};
    plan.blocks = 4;
    plan.block_size = 10;
    plan.timed = 2;
    plan.finest = 960;
    plan.most_work = 2'000;
    return plan;
}

std::vector<double> steps_of(const Contender& contender, const Plan& plan) {
    std::vector<double> steps;
    for (int n = contender.coarsest; n <= std::min(contender.finest, plan.finest); n *= 2)
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

std::string name_of(const Unit& unit) {
    const std::string number = std::to_string(unit.block + 1);
    return unit.variant->name + "-" + std::string(3 - std::min<std::size_t>(3, number.size()), '0') + number;
}

fs::path windows_file(const Unit& unit, const fs::path& folder) {
    return folder / "windows" / (name_of(unit) + ".json");
}

fs::path runs_file(const Unit& unit, const fs::path& folder) {
    return folder / "runs" / (name_of(unit) + ".csv");
}

std::string origin_of_unit(std::string_view kind, std::string_view plan, const Unit& unit) {
    return origin_of(kind, {plan, name_of(unit)});
}

}  // namespace flipside::lab::sweep

#include "lab/report/best_settings.hpp"

#include <algorithm>
#include <cmath>

#include "lab/sweep/contenders.hpp"
#include "lab/sweep/windows.hpp"

namespace flipside::lab::report {

namespace {

constexpr double hardly_cheaper = 0.9;

bool may_be_taken(const sweep::Figures& f) {
    return f.median_high <= good_enough && f.dt <= frame * (1 + 1e-9) && std::isfinite(f.cpu_min);
}

/// The cheapest of those that may be taken and that `allowed` allows.
template <class Allowed>
const sweep::Figures* cheapest(std::span<const sweep::Figures> of_variant, Allowed allowed) {
    const sweep::Figures* best = nullptr;
    for (const sweep::Figures& f : of_variant) {  // of each contender the longest step first
        if (!may_be_taken(f) || !allowed(f)) continue;
        const double enough = best != nullptr && best->contender == f.contender ? hardly_cheaper : 1;
        if (best == nullptr || f.cpu_min < enough * best->cpu_min) best = &f;
    }
    return best;
}

std::optional<Median> ratio_of(const sweep::Figures& dear, const sweep::Figures& cheap) {
    std::vector<double> ratios;
    for (const auto& [window, cost] : dear.costs)
        if (const auto at = cheap.costs.find(window); at != cheap.costs.end() && at->second > 0)
            ratios.push_back(cost / at->second);
    constexpr std::size_t fewest = 6;  // of which the range is an interval of 95 %
    if (ratios.size() < fewest) return {};
    return median_of(std::move(ratios));
}

Best best_of(std::span<const sweep::Figures> of_variant) {
    Best best{of_variant.front().variant, nullptr, nullptr, {}, nullptr};
    const std::string_view truth = sweep::reference_for(Scene{}).engine->name;
    const auto is_yardstick = [&](const sweep::Figures& f) { return f.engine == truth; };
    best.take = cheapest(of_variant, [&](const auto& f) { return !is_yardstick(f); });
    if (best.take == nullptr) return best;
    best.instead = cheapest(of_variant,
                            [&](const auto& f) { return !is_yardstick(f) && f.engine != best.take->engine; });
    if (best.instead != nullptr) best.ratio = ratio_of(*best.instead, *best.take);
    const sweep::Figures* const yardstick = cheapest(of_variant, is_yardstick);
    if (yardstick != nullptr && yardstick->cpu_min < hardly_cheaper * best.take->cpu_min)
        best.yardstick = yardstick;
    return best;
}

}  // namespace

std::vector<Best> best_settings(std::span<const sweep::Figures> all) {
    std::vector<Best> best;
    for (auto begin = all.begin(); begin != all.end();) {
        const auto end = std::find_if(begin, all.end(),
                                      [&](const sweep::Figures& f) { return f.variant != begin->variant; });
        best.push_back(best_of({begin, end}));
        begin = end;
    }
    return best;
}

bool ignores_step(std::span<const sweep::Figures> all, const sweep::Figures& one) {
    double least = INFINITY, most = 0, longest = 0, shortest = INFINITY;
    for (const sweep::Figures& f : all) {
        if (f.variant != one.variant || f.contender != one.contender) continue;
        least = std::min(least, f.median), most = std::max(most, f.median);
        longest = std::max(longest, f.dt), shortest = std::min(shortest, f.dt);
    }
    constexpr double wide = 7.5;  // from 1/30 to 1/240 s, and rounding
    return longest > wide * shortest && most <= std::max(2 * least, sweep::exact_radii);
}

bool is_telling(const sweep::Figures& one, std::span<const Best> best) {
    const auto all = sweep::all_contenders();
    const auto first = std::ranges::find(all, one.engine, &sweep::Contender::engine);
    if (first != all.end() && (*first)->name == one.contender) return true;
    return std::ranges::any_of(best, [&](const Best& b) {
        const auto is_it = [&](const sweep::Figures* f) {
            return f != nullptr && f->variant == one.variant && f->contender == one.contender;
        };
        return is_it(b.take) || is_it(b.instead);
    });
}

}  // namespace flipside::lab::report

#include "lab/report/advice.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

#include "lab/report/contender.hpp"
#include "lab/sweep/windows.hpp"

namespace flipside::lab::report {

namespace {

std::string setting_of(const sweep::Figures& f) {
    return f.contender + " at " + step_text(f.dt);
}

/// "16 times (14 to 19)".
std::string ratio_of(const Best& best) {
    const Median ratio =
        best.ratio.value_or(Median{best.instead->cpu_min / best.take->cpu_min, std::nan(""), std::nan("")});
    return times_text(ratio.value) +
           (std::isnan(ratio.low) ? ""
                                  : " (" + rounded_text(ratio.low) + " to " + rounded_text(ratio.high) + ")");
}

/// How often each engine is chosen: "custom in 4 of 4 kinds of scene".
std::string winners(std::span<const Best> all) {
    std::map<std::string, std::size_t> wins;
    for (const Best& best : all)
        if (best.take != nullptr) ++wins[best.take->engine];
    std::string text;
    for (const auto& [engine, count] : wins)
        text += (text.empty() ? "" : ", ") + engine + " in " + std::to_string(count);
    return text + " of " + std::to_string(all.size()) + " kinds of scene";
}

/// By how much, kind by kind.
std::string leads(std::span<const Best> all) {
    std::string text, none;
    for (const Best& best : all) {
        if (best.take == nullptr) continue;
        std::string& list = best.instead == nullptr ? none : text;
        list += (list.empty() ? "" : "; ");
        if (best.instead != nullptr) list += ratio_of(best) + " as much on ";
        list += kind_of(best.variant);
    }
    if (!text.empty()) text = " The best setting tried of any other engine costs " + text + ".";
    if (!none.empty()) text += " No setting tried of another engine surely gets there on " + none + ".";
    return text;
}

}  // namespace

std::string kind_of(const std::string& variant) {
    const auto standard = sweep::standard_variants();
    const auto at = std::ranges::find(standard, variant, &sweep::Variant::name);
    if (at == standard.end()) return variant;
    const std::string balls = std::to_string(at->balls) + (at->balls == 1 ? " ball" : " balls");
    return at->scene + (at->balls > 0 ? ", " + balls : "");
}

Pick pick_of(const std::vector<sweep::Figures>& all, const Best& best) {
    if (best.take == nullptr)
        return {kind_of(best.variant),
                "nothing",
                std::string(colour::grey),
                "no setting comes within " + rounded_text(good_enough) + " radii",
                "",
                ""};
    const sweep::Figures& f = *best.take;
    const std::string none = "none is surely within " + rounded_text(good_enough) + " radii";
    return {kind_of(best.variant),
            f.contender + " at " + step_text(f.dt) + (ignores_step(all, f) ? " or any other step" : ""),
            colour_of(f.engine),
            (f.median_high <= sweep::exact_radii ? "exact: " : "") + rounded_text(f.median) + " (" +
                rounded_text(f.median_low) + " to " + rounded_text(f.median_high) + ")",
            time_text(f.cpu_min),
            best.instead == nullptr ? none
                                    : setting_of(*best.instead) + ": " + rounded_text(best.instead->median) +
                                          " radii, " + ratio_of(best) + " the cost"};
}

std::vector<std::string> findings_of(const std::vector<sweep::Figures>& all, std::span<const Best> best) {
    std::vector<std::string> findings{
        "Cheapest of all that are off by less than " + rounded_text(good_enough) +
        " radii a few tenths of a second later: " + winners(best) + "." + leads(best)};
    std::vector<std::string> told;
    std::string any, others;
    for (const Best& b : best)
        for (const sweep::Figures* f : {b.take, b.instead}) {
            if (f == nullptr || std::ranges::find(told, f->contender) != told.end()) continue;
            told.push_back(f->contender);
            std::string& list = ignores_step(all, *f) ? any : others;
            list += (list.empty() ? "" : ", ") + f->contender;
        }
    if (!any.empty())
        findings.push_back(
            "Which step? With " + any +
            " the longest that your controls can bear: it is off by as little at any step" +
            (others.empty() ? "." : ". With " + others + " the one that stands in the table above."));
    for (const Best& b : best)
        if (b.yardstick != nullptr)
            findings.push_back("On " + kind_of(b.variant) + " the exact " + b.yardstick->engine +
                               ", which refuses what it cannot do exactly, is cheaper still: " +
                               time_text(b.yardstick->cpu_min) + " a second instead of " +
                               time_text(b.take->cpu_min) + ".");
    return findings;
}

}  // namespace flipside::lab::report

#include "lab/report/blame_tables.hpp"

#include <algorithm>
#include <cstdio>

#include "lab/sweep/blame_counts.hpp"

namespace flipside::lab::report {

namespace {

constexpr const char* how_to_read =
    " A divergence is a run that is not exact; it is blamed on the decision after which even the exact "
    "engine, "
    "going on from there, would end half as far off, or a radius.";

std::string percent_of(std::size_t count, std::size_t all) {
    char text[32];
    std::snprintf(text, sizeof text, "%.1f %%", 100 * static_cast<double>(count) / static_cast<double>(all));
    return text;
}

void add_rows(Table& table, const sweep::BlameShares& of) {
    if (of.shares.empty())
        table.rows.push_back({{of.contender}, {"none", false, "good"}, {}, {}, {}, {"0", true}, {}});
    for (const auto& share : of.shares)
        table.rows.push_back({{of.contender},
                              {std::string(name_of(share.fault))},
                              {std::string(stage_of(share.fault))},
                              {share.kind == "none" ? "in flight" : share.kind},
                              {share.part},
                              {std::to_string(share.count), true},
                              {percent_of(share.count, of.divergences), true}});
}

}  // namespace

std::vector<Table> blame_tables(const std::vector<sweep::Figures>& all, std::span<const Best> best) {
    std::vector<Table> tables;
    std::string variant;
    for (const sweep::BlameShares& one : sweep::blame_shares(all)) {
        if (one.variant != variant) {
            variant = one.variant;
            tables.push_back(
                {"blame-" + variant,
                 "Where errors begin: " + variant,
                 {"Contender", "First wrong decision", "Stage", "At", "Mostly", "Divergences", "Share"},
                 {},
                 ""});
        }
        add_rows(tables.back(), one);
        const auto of = [&](const sweep::Figures& f) {
            return f.variant == one.variant && f.contender == one.contender;
        };
        if (is_telling(*std::ranges::find_if(all, of), best))
            tables.back().reading += (tables.back().reading.empty() ? "" : " ") + sweep::sentence_of(one);
    }
    for (Table& table : tables) table.reading += how_to_read;
    return tables;
}

}  // namespace flipside::lab::report

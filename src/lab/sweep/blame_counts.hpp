#pragma once
/// Divergences of a sweep counted by what they are blamed on (lab/blame/blame.hpp).

#include "lab/sweep/summary.hpp"

namespace flipside::lab::sweep {

/// Of a contender on a variant, over all its step sizes.
struct BlameShares {
    std::string variant, contender;
    std::size_t divergences = 0;
    struct Share {
        Fault fault;
        std::string kind;  ///< one of met_kinds
        std::size_t count;
        std::string part;  ///< the one that is met most often among them, "" in flight
    };
    std::vector<Share> shares;  ///< most frequent first; their counts add up to `divergences`
};
/// In the order of the figures.
[[nodiscard]] std::vector<BlameShares> blame_shares(std::span<const Figures> figures);

/// "61 % begin at arcs, as late contacts", "12 % begin in flight, as drift".
[[nodiscard]] std::string in_words(const BlameShares::Share& share, std::size_t divergences);
/// "Of box2d's 240 divergences on pinball-1 61 % begin at arcs, as late contacts, and ..."; the greatest two.
[[nodiscard]] std::string sentence_of(const BlameShares& shares);

/// CSV: variant,contender,dt,fault,stage,kind,met,divergences. A row for each that there is.
void write_blame(const std::filesystem::path& file, std::span<const Figures> all);

}  // namespace flipside::lab::sweep

#include "lab/sweep/blame_counts.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "lab/files/csv.hpp"
#include "lab/files/whole_file.hpp"

namespace flipside::lab::sweep {

namespace {

/// "begin at arcs, as late contacts".
std::string beginning_of(const BlameShares::Share& share) {
    switch (share.fault) {
        case Fault::drift:
            return "begin in flight, as drift";
        case Fault::stopped:
            return "are runs that stopped";
        case Fault::unknown:
            return "begin for reasons unknown";
        default:
            break;
    }
    const std::string at = "begin at " + share.kind + "s, as ";
    switch (share.fault) {
        case Fault::normal:
            return at + "wrong normals";
        case Fault::impulse:
            return at + "wrong impulses";
        case Fault::friction:
            return at + "wrong friction";
        case Fault::motion:
            return at + "mistimed parts";
        case Fault::unpaired:
            return at + "pairs not found";
        case Fault::let_through:
            return at + "balls let through";
        default:
            return at + std::string(name_of(share.fault)) + " contacts";
    }
}

BlameShares shares_of(const Figures& first, const BlameCounts& counts) {
    BlameShares all{first.variant, first.contender, 0, {}};
    std::size_t most = 0;                      // of the parts of one share
    for (const auto& [key, count] : counts) {  // by fault, then kind
        all.divergences += count;
        if (all.shares.empty() ||
            std::tie(all.shares.back().fault, all.shares.back().kind) != std::tie(key.fault, key.kind)) {
            all.shares.push_back({key.fault, key.kind, 0, ""});
            most = 0;
        }
        all.shares.back().count += count;
        if (count > most) most = count, all.shares.back().part = key.met;
    }
    std::ranges::stable_sort(all.shares, std::greater{}, &BlameShares::Share::count);
    return all;
}

}  // namespace

std::vector<BlameShares> blame_shares(std::span<const Figures> figures) {
    std::vector<BlameShares> all;
    for (auto begin = figures.begin(); begin != figures.end();) {
        BlameCounts counts;
        auto end = begin;
        for (; end != figures.end() && end->variant == begin->variant && end->contender == begin->contender;
             ++end)
            for (const auto& [key, count] : end->blame) counts[key] += count;
        all.push_back(shares_of(*begin, counts));
        begin = end;
    }
    return all;
}

std::string in_words(const BlameShares::Share& share, std::size_t divergences) {
    const double percent = 100 * static_cast<double>(share.count) / static_cast<double>(divergences);
    return (percent < 1 ? "less than 1" : std::to_string(std::lround(percent))) + " % " + beginning_of(share);
}

std::string sentence_of(const BlameShares& shares) {
    if (shares.divergences == 0) return shares.contender + " never diverges on " + shares.variant + ".";
    std::string sentence = "Of the " + std::to_string(shares.divergences) + " divergences of " +
                           shares.contender + " on " + shares.variant + " " +
                           in_words(shares.shares.front(), shares.divergences);
    if (shares.shares.size() > 1) sentence += ", and " + in_words(shares.shares[1], shares.divergences);
    return sentence + ".";
}

void write_blame(const std::filesystem::path& file, std::span<const Figures> all) {
    WholeFile whole(file);
    whole.out() << "variant,contender,dt,fault,stage,kind,met,divergences\n";
    CsvRow row;
    for (const Figures& f : all)
        for (const auto& [key, count] : f.blame)
            row.add(f.variant)
                .add(f.contender)
                .add(f.dt)
                .add(name_of(key.fault))
                .add(stage_of(key.fault))
                .add(key.kind)
                .add(key.met)
                .add(count)
                .write(whole.out());
    whole.finish();
}

}  // namespace flipside::lab::sweep

#pragma once
/// What to take for the scenes of a sweep: the cheapest settings that are good enough, and the best of the
/// other engines beside them.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "lab/statistics/median.hpp"
#include "lab/sweep/summary.hpp"

namespace flipside::lab::report {

/// Good enough is what is off by less than this, radii: the median of the windows, its 95 % interval
/// included.
inline constexpr double good_enough = 0.1;
/// A game shows a frame that often, s: longer steps are left out.
inline constexpr double frame = 1.0 / 60;

struct Best {
    std::string variant;
    const sweep::Figures* take = nullptr;       ///< null where no setting of any engine is good enough
    const sweep::Figures* instead = nullptr;    ///< of another engine; null where none of theirs is
    std::optional<Median> ratio;                ///< its cost over that of `take`, of six windows or more
    const sweep::Figures* yardstick = nullptr;  ///< cheaper still, of the engine that all are held against
};
/// One per variant, in the order of the figures, to which they point. Where a shorter step costs no more than
/// a tenth less, the longer one is taken. The engine that all are held against (windows.hpp) stands aside: it
/// refuses what it cannot do exactly.
[[nodiscard]] std::vector<Best> best_settings(std::span<const sweep::Figures> all);

/// Whether the error of this contender is exact, or stays as it is within a factor of two, from its longest
/// step to its shortest, which is an eighth of that or less.
[[nodiscard]] bool ignores_step(std::span<const sweep::Figures> all, const sweep::Figures& one);

/// What a figure shows at once: the first contender of each engine, and those that are best.
[[nodiscard]] bool is_telling(const sweep::Figures& one, std::span<const Best> best);

}  // namespace flipside::lab::report

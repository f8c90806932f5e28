#include "lab/comparison/impact_verdict.hpp"

#include <algorithm>

namespace flipside::lab {

std::optional<ImpactVerdict> judge(const ImpactLog& contender, const ImpactLog& exact, Other subject,
                                   double tolerance, double now, double certain) {
    const auto mine = contender.last(subject, now);
    const auto truth = exact.last(subject, std::min(now, certain));
    const double settled = std::min(now - tolerance, certain);
    const bool behind = truth && (!mine || mine->event.time < truth->event.time);
    if (behind && truth->event.time < settled && !contender.nearest(truth->event, tolerance, now))
        return ImpactVerdict{truth->event, true, {}};
    if (!mine || mine->event.time > certain) return std::nullopt;
    if (const auto match = exact.nearest(mine->event, tolerance, now))
        return ImpactVerdict{mine->event, false, error_of(mine->event, match->event)};
    if (mine->event.time < settled) return ImpactVerdict{mine->event, false, {}};
    return std::nullopt;
}

}  // namespace flipside::lab

#include "lab/comparison/live_match.hpp"

#include <algorithm>

namespace flipside::lab {

void LiveMatch::observe(std::span<const Event> first, std::span<const Event> second, double tolerance,
                        double time) {
    for (const Event& event : first)
        if (event.kind == EventKind::impact) balls_[event.ball].first.push_back(event);
    for (const Event& event : second)
        if (event.kind == EventKind::impact) balls_[event.ball].second.push_back(event);
    for (auto& [ball, waiting] : balls_) match(ball, waiting, tolerance, time);
}

void LiveMatch::match(BallNumber ball, Waiting& waiting, double tolerance, double time) {
    auto& [first, second, index, parted] = waiting;
    while (!parted && !(first.empty() && second.empty())) {
        Parting found{time, ball, index, {}, {}};
        if (!first.empty()) found.first = first.front();
        if (!second.empty()) found.second = second.front();
        if (found.first && found.second && same_impact(*found.first, *found.second, tolerance)) {
            first.pop_front();
            second.pop_front();
            ++index;
            continue;
        }
        if (found.first) found.time = std::min(found.time, found.first->time);
        if (found.second) found.time = std::min(found.time, found.second->time);
        if (!(found.first && found.second) && found.time >= time - tolerance) return;
        parted = true;
        if (!parting_ || found.time < parting_->time) parting_ = found;
    }
    if (!parted) return;
    first.clear();
    second.clear();
}

}  // namespace flipside::lab

#include "app/window/divergence.hpp"

#include <algorithm>
#include <utility>

#include "lab/files/csv.hpp"

namespace flipside::app {

void Divergence::observe(const Run& first, const Run& second) {
    if (first.halt() || second.halt()) return;
    const lab::Session &a = first.session(), &b = second.session();
    const double time = a.world().time();
    const bool empty = a.world().balls().empty() && b.world().balls().empty();
    // What comes onto two empty tables begins alike on both.
    if (!empty && std::exchange(was_empty_, false)) match_ = {};
    was_empty_ = empty;
    // Engines that only know contacts per step give the step's end: one step is what impacts may differ by.
    match_.observe(first.events(), second.events(), std::max(first.dt(), second.dt()) * (1 + 1e-9), time);
    if (!first_parting_) first_parting_ = parting();
    const lab::Spread spread = lab::spread(a.world().balls(), b.world().balls());
    if (spread.common > 0) remember(history_, {time, spread.radii});
}

void Divergence::forget_after(double time) {
    flipside::app::forget_after(history_, time);
    if (!parting() || parting()->time > time) match_ = {};
    if (first_parting_ && first_parting_->time > time) first_parting_.reset();
}

std::string Divergence::parted_on(const Scene& scene) const {
    return parting() ? name_of_parting(*parting(), scene) : "";
}

std::string name_of_parting(const lab::Parting& parting, const Scene& scene) {
    const auto& [time, ball, index, first, second] = parting;
    const Event& event = first && first->time == time ? *first : *second;
    // Files call it "ball:5".
    return event.other.is_ball ? "ball " + std::to_string(event.other.index)
                               : lab::name_of_other(event, scene);
}

}  // namespace flipside::app

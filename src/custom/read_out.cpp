// What a world tells of itself after a step: contacts, events, statistics and drawings.

#include <algorithm>
#include <tuple>

#include "custom/world.hpp"

namespace flipside::custom {

std::span<const Event> CustomWorld::events() const {
    find_contacts();
    return record_.events;
}

std::span<const Contact> CustomWorld::contacts() const {
    find_contacts();
    return contacts_.contacts();
}

/// Finds the contacts after a step, and reports those that began or ended.
void CustomWorld::find_contacts() const {
    if (steps_since_contacts_ == 0) return;
    // Balls that slept all the time have the same contacts.
    if (simple_ || steps_since_contacts_ > 1 || continuous_->sleep_changed())
        contacts_.search(balls_);
    else
        contacts_.refresh(balls_, continuous_->find_pairs(balls_));
    steps_since_contacts_ = 0;
    record_.statistics.narrow_tests += contacts_.pairs().size();
    contacts_.report_touches(record_.events);
    if (simple_) contacts_.report_sensors(record_.crossed, record_.events);
    std::ranges::sort(record_.events, {}, [](const Event& event) {
        return std::tie(event.time, event.kind, event.ball, event.other, event.speed, event.impulse,
                        event.normal.x, event.normal.y, event.point.x, event.point.y);
    });
}

/// Finds the contacts after balls have changed in any way but by a step.
void CustomWorld::search_contacts() {
    steps_since_contacts_ = 0;
    contacts_.search(balls_);
    record_.statistics.narrow_tests += contacts_.pairs().size();
}

void CustomWorld::fill_statistics(std::uint64_t pair_tests) {
    Statistics& statistics = record_.statistics;
    statistics.solver = settings_.solver;
    statistics.event_ordered = continuous_ != nullptr;
    statistics.pair_tests += pair_tests;
    const bool all_sleep = continuous_ && continuous_->quiet();
    statistics.asleep = static_cast<std::uint64_t>(all_sleep ? std::ssize(balls_)
                                                             : std::ranges::count_if(balls_, &Ball::asleep));
    statistics.broad_phase.name = "cells";
    if (continuous_) return;  // events of all kinds alternate, so there are no stages
    statistics.broad_phase = broad_->facts();
    constexpr std::string_view stages[] = {"broad phase", "flight", "contact", "report"};
    for (std::size_t i = 0; i < std::size(stages); ++i) statistics.stages[i].name = stages[i];
}

void CustomWorld::inspect(Inspector& inspector) const {
    const auto bounds = [&](const Primitive& primitive) {
        return bounds_of(primitive, table_.pose(primitive.part));
    };
    if (inspector.wants(Topic::boxes)) {
        for (const Primitive& primitive : layout_.primitives())
            inspector.box(Topic::boxes, bounds(primitive));
        for (const Ball& ball : balls_) inspector.box(Topic::boxes, bounds_of(ball.position, ball.radius));
    }
    if (inspector.wants(Topic::cells) && continuous_) continuous_->inspect_cells(inspector);
    if (inspector.wants(Topic::cells) && simple_) broad_->inspect(inspector);
    if (inspector.wants(Topic::pairs)) {
        find_contacts();
        const auto place = [&](Handle handle) {
            if (handle >= layout_.size()) return balls_[handle - layout_.size()].position;
            return middle_of(bounds(layout_.primitive(handle)));
        };
        for (const Pair pair : contacts_.pairs()) inspector.pair(place(pair.a), place(pair.b));
    }
    if (inspector.wants(Topic::contacts))
        for (const Contact& contact : contacts()) inspector.contact(contact);
    if (inspector.wants(Topic::sleep))
        for (const Ball& ball : balls_)
            if (ball.asleep) inspector.circle(Topic::sleep, ball.position, ball.radius);
}

}  // namespace flipside::custom

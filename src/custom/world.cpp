// A step of the world, and its contacts, events and statistics.

#include "custom/world.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "custom/broad_phase/capacity.hpp"
#include "custom/broad_phase/registry.hpp"
#include "custom/engine.hpp"
#include "world/limits.hpp"

namespace flipside::custom {

CustomWorld::CustomWorld(std::shared_ptr<const Scene> scene, const Settings& settings)
    : scene_(std::move(scene)),
      settings_(settings),
      table_(scene_),
      layout_(*scene_),
      broad_(make_broad_phase(*scene_, layout_.still_proxies(), settings)),
      balls_(scene_->balls) {
    if (settings_.solver == "simple")
        simple_ = std::make_unique<SimpleSolver>(*scene_, layout_, settings_);
    else
        continuous_ = std::make_unique<ContinuousSolver>(table_, layout_, *broad_, settings_);
    if (continuous_) continuous_->load(balls_);
    reserve_for();
    search_contacts();
    fill_statistics(0);
}

/// Lists grow here, when balls are added, and hardly ever in a step.
void CustomWorld::reserve_for() {
    custom::reserve_for(balls_, balls_.size() + 1);
    if (simple_) simple_->reserve(balls_.size());
    if (continuous_) continuous_->reserve(balls_.size());
    guard_.reserve(balls_.capacity(), std::max(least_capacity, balls_.capacity() * contacts_per_ball));
    contacts_.reserve(layout_.size(), balls_.size());
    custom::reserve_for(table_.memory().forces, balls_.size(), contacts_per_ball);
    custom::reserve_for(table_.memory().inside, balls_.size(), touches_per_ball);
    custom::reserve_for(table_.reported_lost(), balls_.size());
    custom::reserve_for(table_.blocked(), balls_.size());
    custom::reserve_for(record_.events, balls_.size(), events_per_ball);
    custom::reserve_for(record_.crossed, balls_.size(), touches_per_ball);
}

void CustomWorld::step(double dt) {
    if (record_.trace) record_.trace->stages.clear();
    if (continuous_) continuous_->keep();
    if (continuous_ && continuous_->can_undo() && !table_.launch_waiting()) {
        const Clock before = table_.clock();
        const bool quiet = continuous_->quiet();
        const auto make = [&] {
            make_step(dt);
            require_limits(engine_name, std::span(balls_).first(quiet ? 0 : balls_.size()), time());
        };
        return guard_.attempt(make, [&] { undo_to(before); });
    }
    guard_.run(
        table_, balls_, [&] { make_step(dt); },
        [&](State before) {
            Table::forget_gone(before);
            if (continuous_) before.origin = continuous_->kept_origin();
            restore(before);
        });
}

void CustomWorld::make_step(double dt) {
    const std::uint64_t tests_before = broad_->tests();
    record_.events.clear();
    record_.crossed.clear();
    record_.statistics = {};
    launch();
    if (simple_) {
        step_simple(dt);
    } else {
        contacts_skipped_ |= !contacts_found_;
        continuous_->step(dt, balls_, record_);
        contacts_found_ = contacts_last_ && continuous_->quiet();
    }
    fill_statistics(broad_->tests() - tests_before);
    if (!record_.trace) return;
    if (continuous_ && continuous_->quiet())
        record_.trace->stage("asleep", "src/custom/continuous/continuous_solver.cpp: ContinuousSolver::step")
            .says = "All balls sleep and no part moves: nothing is done.";
    trace_read_out(*record_.trace, "src/custom/world.cpp: CustomWorld::make_step", *this, *scene_);
}

void CustomWorld::launch() {
    while (table_.launch_waiting()) {
        const auto launched = table_.launch(balls_);
        if (!launched) return;
        interrupt();
        if (launched->existing) {
            *std::ranges::lower_bound(balls_, launched->ball.number, {}, &Ball::number) = launched->ball;
        } else {
            balls_.push_back(launched->ball);
            balls_.back().number = table_.new_number();
            reserve_for();
        }
    }
}

void CustomWorld::step_simple(double dt) {
    record_.broad_seconds = record_.flight_seconds = record_.contact_seconds = record_.report_seconds = 0;
    simple_->step(table_, balls_, dt, *broad_, record_);
    table_.advance(dt);
    Stopwatch watch;
    lose_balls();
    search_contacts();
    contacts_.report_touches(time(), record_.events);
    contacts_.report_sensors(time(), record_.crossed, record_.events);
    sort_events();
    watch.lap(record_.report_seconds);
}

/// Handles the balls that have left the bounds in a step of the simple solver.
void CustomWorld::lose_balls() {
    auto& reported = table_.reported_lost();
    const auto outside = [&](const Ball& ball) { return !scene_->bounds.contains(ball.position); };
    for (const Ball& ball : balls_) {
        if (!outside(ball) || std::ranges::find(reported, ball.number) != reported.end()) continue;
        record_.events.push_back({time(), EventKind::lost, ball.number, {}, ball.position, {}, 0, 0});
        if (scene_->keep_lost) reported.push_back(ball.number);
    }
    if (!scene_->keep_lost) std::erase_if(balls_, outside);
}

std::span<const Event> CustomWorld::events() const {
    find_contacts();
    return record_.events;
}

std::span<const Contact> CustomWorld::contacts() const {
    find_contacts();
    return contacts_.contacts();
}

/// Finds the contacts after a step of the continuous solver.
void CustomWorld::find_contacts() const {
    if (contacts_found_) return;
    contacts_found_ = true;
    contacts_last_ = continuous_->quiet();
    // Balls that slept since then have the same contacts.
    if (contacts_skipped_ || continuous_->fell_asleep())
        contacts_.search(layout_, table_, balls_, *broad_);
    else
        contacts_.refresh(layout_, table_, balls_, continuous_->find_pairs(balls_));
    contacts_skipped_ = false;
    record_.statistics.narrow_tests += contacts_.narrow_tests();
    contacts_.report_touches(time(), record_.events);
    sort_events();
}

/// Finds the contacts after balls have changed in any way but by a step of the continuous solver.
void CustomWorld::search_contacts() {
    contacts_found_ = true;
    contacts_last_ = contacts_skipped_ = false;
    contacts_.search(layout_, table_, balls_, *broad_);
    record_.statistics.narrow_tests += contacts_.narrow_tests();
}

void CustomWorld::sort_events() const {
    std::ranges::sort(record_.events, [](const Event& a, const Event& b) {
        return std::tie(a.time, a.kind, a.ball, a.other, a.speed, a.impulse) <
               std::tie(b.time, b.kind, b.ball, b.other, b.speed, b.impulse);
    });
}

void CustomWorld::fill_statistics(std::uint64_t pair_tests) {
    Statistics& statistics = record_.statistics;
    statistics.solver = settings_.solver;
    statistics.event_ordered = continuous_ != nullptr;
    statistics.pair_tests += pair_tests;
    const bool all_sleep = continuous_ && continuous_->quiet();
    statistics.asleep = static_cast<std::uint64_t>(all_sleep ? std::ssize(balls_)
                                                             : std::ranges::count_if(balls_, &Ball::asleep));
    if (continuous_) {
        // Events of all kinds alternate, so there are no stages.
        statistics.broad_phase.name = "cells";
        return;
    }
    statistics.broad_phase = broad_->facts();
    statistics.stages[0] = {"broad phase", record_.broad_seconds};
    statistics.stages[1] = {"flight", record_.flight_seconds};
    statistics.stages[2] = {"contact", record_.contact_seconds};
    statistics.stages[3] = {"report", record_.report_seconds};
}

}  // namespace flipside::custom

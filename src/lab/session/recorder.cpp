#include "lab/session/recorder.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lab/session/timeline.hpp"

namespace flipside::lab {

namespace {

std::size_t bytes_of(const State& state) {
    return sizeof(State) + state.balls.size() * sizeof(Ball) + state.parts.size() * sizeof(PartState) +
           state.memory.forces.size() * sizeof(ContactForce) + state.blocked.size() * sizeof(Blocked) +
           state.launches.size() * sizeof(control::Launch) + state.reported_lost.size() * sizeof(BallNumber);
}

std::size_t bytes_of(const Session::Snapshot& snapshot) {
    const State& state = snapshot.state;
    return sizeof snapshot + bytes_of(state) + (state.origin ? bytes_of(*state.origin) : 0) +
           snapshot.events.size() * sizeof(Event);
}

}  // namespace

void Recorder::start(const Session& session, std::size_t next_control) {
    moments_.clear();
    bytes_ = 0;
    moments_.push_back({session.world().time(), {}, next_control, session.totals(), {}, 0});
    keep(moments_.back(), session, session.events());
}

void Recorder::keep(Moment& moment, const Session& session, std::span<const Event> events) {
    moment.snapshot = session.snapshot(events);
    bytes_ -= moment.bytes;
    moment.bytes = sizeof(Moment) + moment.way.controls.size() * sizeof(Control) + bytes_of(*moment.snapshot);
    bytes_ += moment.bytes;
}

void Recorder::record(const Session& session, Way way, std::span<const Event> events,
                      std::size_t next_control) {
    const std::size_t bytes = sizeof(Moment) + way.controls.size() * sizeof(Control);
    moments_.push_back({session.world().time(), std::move(way), next_control, session.totals(), {}, bytes});
    bytes_ += bytes;
    Moment& now = moments_.back();
    const auto last = std::find_if(moments_.rbegin(), moments_.rend(),
                                   [](const Moment& moment) { return moment.snapshot.has_value(); });
    const bool due = now.time - last->time >= between_snapshots ||
                     session.totals().step_seconds - last->snapshot->totals.step_seconds >= dearest_replay;
    if (due || !session.engine().restores_exactly) keep(now, session, events);
    drop();
}

void Recorder::changed(const Session& session, std::span<const Event> events) {
    keep(moments_.back(), session, events);
}

void Recorder::drop() {
    const auto second = [this] {
        return std::find_if(moments_.begin() + 1, moments_.end(),
                            [](const Moment& moment) { return moment.snapshot.has_value(); });
    };
    // The next one that can be gone back to must do in its place.
    for (auto next = second(); next != moments_.end(); next = second()) {
        if (next->time > moments_.back().time - longest && bytes_ <= most_bytes) return;
        for (auto moment = moments_.begin(); moment != next; ++moment) bytes_ -= moment->bytes;
        moments_.erase(moments_.begin(), next);
    }
}

std::size_t Recorder::at(double time) const {
    const auto after = std::upper_bound(moments_.begin(), moments_.end(), time + same_time,
                                        [](double t, const Moment& moment) { return t < moment.time; });
    return after == moments_.begin() ? 0 : static_cast<std::size_t>(after - moments_.begin()) - 1;
}

std::vector<Event> Recorder::restore(std::size_t moment, Session& session, const Script& script) const {
    std::size_t from = moment;
    while (!moments_[from].snapshot) --from;
    session.restore(*moments_[from].snapshot);
    std::vector<Event> events = moments_[from].snapshot->events;
    std::size_t next = moments_[from].next_control;
    for (std::size_t i = from + 1; i <= moment; ++i) {
        const Way& way = moments_[i].way;
        for (const Control& control : way.controls) session.apply(control);
        const Timeline steps(0, way.span, way.dt);
        events.clear();
        for (std::uint64_t k = 0; k < steps.steps(); ++k) {
            session.step(steps.length(k), script, next);
            events.insert(events.end(), session.events().begin(), session.events().end());
        }
    }
    session.recount(moments_[moment].totals);
    return events;
}

void Recorder::forget_after(std::size_t moment) {
    while (moments_.size() > moment + 1) {
        bytes_ -= moments_.back().bytes;
        moments_.pop_back();
    }
}

}  // namespace flipside::lab

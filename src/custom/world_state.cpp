// What a world saves, and how it goes on from there.

#include <utility>

#include "custom/world.hpp"

namespace flipside::custom {

State CustomWorld::save() const {
    State state = table_.save(balls_);
    if (windows_) state.origin = windows_->origin();
    return state;
}

void CustomWorld::restore(const State& state) {
    guard_.forget();
    Trace* const trace = std::exchange(record_.trace, nullptr);  // this is no step
    if (!resume(state)) load(state);
    record_.events.clear();
    record_.statistics = {};
    search_contacts();
    fill_statistics(0);
    record_.trace = trace;
}

void CustomWorld::load(const State& state) {
    table_.restore(state);
    balls_ = state.balls;
    if (windows_) windows_->begin_anew();
    reserve_for();
}

/// Goes through the window in which the state was saved, from its start. False where that does not lead to
/// the state: it is another engine's, or was changed.
bool CustomWorld::resume(const State& state) {
    if (!state.origin || !windows_) return false;
    load(*state.origin);
    if (!windows_->resume(state, balls_, record_)) return false;
    State reached = save();
    reached.origin = state.origin;
    return reached == state;
}

}  // namespace flipside::custom

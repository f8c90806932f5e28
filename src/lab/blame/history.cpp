#include "lab/blame/history.hpp"

namespace flipside::lab {

namespace {

/// Without what only the engine that saved it can use: others must go on from the balls as they are.
State plain(State state) {
    state.memory = {};
    state.origin.reset();
    return state;
}

}  // namespace

void History::begin(const World& world) {
    states.push_back(plain(world.save()));
    contacts.emplace_back(world.contacts().begin(), world.contacts().end());
}

void History::add(const World& world, std::span<const Event> happened) {
    begin(world);
    auto& kept = events.emplace_back();
    for (const Event& event : happened)
        if (event.kind == EventKind::impact || event.kind == EventKind::begin) kept.push_back(event);
}

}  // namespace flipside::lab

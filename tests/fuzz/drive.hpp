#pragma once
/// Runs a scene on one engine, and asks after every step what must hold on all of them.

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "lab/session/session.hpp"

namespace flipside::fuzz {

/// An engine, with the settings that make it another solver.
struct Contender {
    const char* name;
    const Engine* engine;
    std::vector<std::pair<std::string, std::string>> settings;
    bool keeps_balls;     ///< never lets a ball through a wall
    bool repeats_states;  ///< continues from a saved state with the same bits
    int steps = 20;       ///< a ride takes: fewer where a step takes long,
    unsigned one_in = 1;  ///< and by one input in so many
    double slowness = 1;  ///< how much longer than others it may take for a step
};
/// custom with each of its solvers, box2d, and the reference with either precision.
[[nodiscard]] const std::vector<Contender>& contenders();

/// Few enough balls and collider primitives that a step has no excuse to be slow.
[[nodiscard]] bool is_small(const Scene& scene);
[[nodiscard]] bool is_small(const State& state);

struct Ride {
    std::shared_ptr<const Scene> scene;
    const Script& script;
    const State* start = nullptr;  ///< null: as the scene begins
    unsigned variation = 0;
    bool closed = false;  ///< nothing can be lost (closed_box.hpp)
};
/// Steps the scene, where it is the contender's turn, saves, reads and restores it half-way and at the end,
/// and compares with a second run.
void drive(const Contender& contender, const Ride& ride);

/// What is written, read and restored into another world is the same, to the bit.
void require_round_trip(const lab::Session& session);

}  // namespace flipside::fuzz

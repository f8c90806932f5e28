#pragma once
/// Everything that changes while a world runs. Save from one engine, restore into another.

#include <memory>
#include <string>
#include <vector>

#include "world/ball.hpp"
#include "world/clock.hpp"
#include "world/controls.hpp"

namespace flipside {

/// What can change about a part. Angle is measured from the pose in the scene file.
struct PartState {
    double angle = 0;   ///< rad
    bool open = false;  ///< a gate with a ball in it
    bool down = false;  ///< a drop target that was hit

    friend bool operator==(const PartState&, const PartState&) = default;
};

/// What two balls exert on each other.
struct ContactForce {
    BallNumber a = 0, b = 0;  ///< a < b
    double normal = 0;        ///< N, above 0
    double tangent = 0;       ///< N, by friction, on a along perp of the normal from b to a

    friend bool operator==(const ContactForce&, const ContactForce&) = default;
};

/// A ball in a sensor, or in a gate that lets it through. A ball whose surface slides along that of a sensor
/// is inside or outside by rounding alone, so its position does not tell.
struct Sensed {
    BallNumber ball = 0;
    PartIndex part = 0;

    friend auto operator<=>(const Sensed&, const Sensed&) = default;
};

/// What an engine keeps from step to step beside the balls: the forces from which its next solve begins (warm
/// starting), which balls are inside of what, or bytes. It counts only for that engine and only at that time,
/// so no other need look at it or clear it.
struct EngineMemory {
    std::string engine;                ///< its name
    double time = 0;                   ///< s
    std::vector<ContactForce> forces;  ///< by b, then a
    std::vector<Sensed> inside{};      ///< by ball, then part
    std::string bytes{};               ///< what an engine from elsewhere keeps; only it can read them

    friend bool operator==(const EngineMemory&, const EngineMemory&) = default;
};

/// A ball within its radius of a gate that does not let it through (gate.hpp).
struct Blocked {
    PartIndex gate = 0;
    BallNumber ball = 0;

    friend auto operator<=>(const Blocked&, const Blocked&) = default;
};

struct State {
    Clock clock;
    BallNumber next_number = 0;
    std::vector<Ball> balls;       ///< by rising number
    std::vector<PartState> parts;  ///< one per part of the scene
    EngineMemory memory;
    std::vector<Blocked> blocked;     ///< by gate, then ball; of closed gates
    bool raised[2] = {false, false};  ///< flipper buttons by Side
    bool rotating = false;
    std::vector<control::Launch> launches;  ///< waiting for a free place, first come first served
    double next_look = 0;                   ///< s: of the launcher, whether its place is free; 0 if none wait
    std::vector<BallNumber> reported_lost;  ///< balls kept in the world after they were reported lost
    /// An earlier state, without an origin of its own, from which the engine that saved this one came here
    /// without a control in between. An engine whose paths last for longer than a step goes on from there, to
    /// continue with the same bits; others need not look at it.
    std::shared_ptr<const State> origin;

    friend bool operator==(const State&, const State&) = default;
};

}  // namespace flipside

#pragma once
/// Everything that changes while a world runs. Save from one engine, restore into another.

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

struct State {
    Clock clock;
    BallNumber next_number = 0;
    std::vector<Ball> balls;          ///< by rising number
    std::vector<PartState> parts;     ///< one per part of the scene
    bool raised[2] = {false, false};  ///< flipper buttons by Side
    bool rotating = false;
    std::vector<control::Launch> launches;  ///< waiting for a free place, first come first served
    std::vector<BallNumber> reported_lost;  ///< balls kept in the world after they were reported lost
};

}  // namespace flipside

#pragma once
/// The touching pairs at the end of a sub-step, found with Box2D's own narrow phase: its contacts hold the
/// state at the start of the step. Gives contacts, sensors and the balls in gates.

#include <vector>

#include <box2d/b2_world.h>

#include "box2d/units.hpp"
#include "world/events.hpp"
#include "world/table.hpp"

namespace flipside::box2d {

struct BallOnPart {
    BallNumber ball = 0;
    PartIndex part = 0;

    friend constexpr auto operator<=>(const BallOnPart&, const BallOnPart&) = default;
};

/// Lists are sorted, each pair is there once.
struct Touching {
    std::vector<Contact>
        contacts;  ///< the deepest of each pair; not sensors, nor gates that let the ball through
    std::vector<BallOnPart> sensors;   ///< balls on sensors
    std::vector<BallOnPart> passed;    ///< balls that crossed a whole sensor since the last look
    std::vector<BallOnPart> at_gates;  ///< balls that touch gates
    std::uint64_t pairs = 0;           ///< what the broad phase holds as candidates

    /// Looks at all candidate pairs. `before` holds the body origins of the balls at the start of the
    /// sub-step, by place in the table's list of balls; empty if nothing moved. Cost: one narrow-phase test
    /// per candidate pair.
    void look(b2World& world, const Table& table, const std::vector<Ball>& balls, const Units& units,
              const std::vector<b2Vec2>& before);
};

}  // namespace flipside::box2d

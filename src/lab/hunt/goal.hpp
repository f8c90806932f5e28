#pragma once
/// Goals of a hunt: the error of a contender on a scene, as one number that should be small.

#include <optional>
#include <string>
#include <string_view>

#include "lab/contenders/contender.hpp"

namespace flipside::lab::hunt {

enum class Goal {
    overlap,  ///< the deepest at the end of any step, in radii of the ball
    energy,   ///< gained, as a share of what the balls could at most have had at the start
    escape,   ///< balls lost from a closed box, or no longer numbers
    /// Distance to the reference, in radii, while that is known and chaos has not begun. A ball that only one
    /// of the two has lost counts as on the border of the bounds, where that is nearest to the other's.
    error,
    work  ///< box and shape tests per ball and step: the engine's own counts, so no noise
};
inline constexpr std::string_view goal_names[] = {"overlap", "energy", "escape", "error", "work"};

/// Of a name; also `lost` for escape and `time` for work. Throws InputError that names what is allowed.
[[nodiscard]] Goal goal_named(std::string_view name);
[[nodiscard]] inline std::string_view name_of(Goal goal) {
    return goal_names[static_cast<int>(goal)];
}
/// "radii", "of the most energy", ...
[[nodiscard]] std::string_view unit_of(Goal goal);

struct Measured {
    double value = 0;    ///< 0 where the engine refuses the scene, and where the goal says nothing of it
    double time = 0;     ///< s, when
    std::string what{};  ///< "ball 2 on part 3"
};

/// Whether a goal is meaningful for a scene. Escapes: if no part moves, since a moving part may drive a ball
/// through a wall, and then no result is right. Overlap and energy: if moreover no part kicks or has a
/// restitution above 1, since a kicked ball in a heap never comes to rest. Errors and work: always.
[[nodiscard]] bool says_something(Goal goal, const Scene& scene);

/// A run of `seconds`; the flippers go up at a third of them. The same arguments give the same bits.
[[nodiscard]] Measured measure(Goal goal, const Contender& contender, const Scene& scene, double seconds);

}  // namespace flipside::lab::hunt

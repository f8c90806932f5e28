#pragma once
/// Windows: short runs whose exact outcome is known. Each starts from a state along a trajectory of the
/// reference engine, lasts 0.1 to 0.5 s, holds at least one hit, and no control changes in it. Each bumper
/// hit multiplies an error by a large factor, so only short runs can say how good an engine is; and far
/// past its horizon a trajectory is still a fair source of states, though no longer the scene's own.
///
/// The outcome is the reference's at 113 bits, and only balls count
///   - whose position it claims, against 226 bits, to `claim_radii`: more digits than a double holds, and
///   - which two of its runs in double precision know to `horizon_radii`, whose starts differ by the last bit
///     of positions and velocities. Past that horizon rounding alone decides (a ball that rolls over an edge
///     turns 1e-16 into 1e-8, and of impacts at one instant it chooses the first), so no engine that computes
///     in double could do better, and the window would tell nothing of the engine.

#include <functional>
#include <map>

#include "lab/contenders/engines.hpp"
#include "lab/sweep/variants.hpp"
#include "world/events.hpp"
#include "world/state.hpp"

namespace flipside::lab::sweep {

inline constexpr double claim_radii = 1e-13, horizon_radii = 1e-11;
/// Up to here, radii, an engine in double precision is as good as exact: a hundred times what its rounding
/// may come to, since each engine rounds in its own way and at every step.
inline constexpr double exact_radii = 100 * horizon_radii;

struct Window {
    /// A ball whose end is known.
    struct End {
        BallNumber ball = 0;
        Vec2 position;           ///< m, rounded to double
        double radius = 0;       ///< m
        double uncertainty = 0;  ///< m, what the reference claims for it
        bool hit = false;        ///< it took part in an impact of this window
    };
    State start;
    double seconds = 0;  ///< a whole number of window_unit
    std::vector<End> ends;
    std::vector<Event> impacts;  ///< in order of time; time, ball, other and speed alone
};

/// The windows of one work unit. A block is made of its own trajectories, and so does not depend on others.
struct Block {
    std::vector<Window> windows;
    std::map<std::string, std::size_t> skipped;  ///< states that made no window, by reason
    std::size_t trajectories = 0;
};

/// The engine that knows: in double precision for the trajectories that states are taken from, at its highest
/// precision for what happens in a window.
struct Truth {
    const Engine* engine = nullptr;
    Settings trajectory, window;
};
[[nodiscard]] Truth reference_for(const Scene& scene);

/// What makes a block: the same arguments give the same windows.
struct BlockPlan {
    Variant variant;
    std::uint64_t seed = 1;
    std::uint32_t index = 0;  ///< of the block within its variant
    std::size_t size = 25;    ///< windows
};
/// Fewer windows than planned where most_trajectories do not give more.
[[nodiscard]] Block make_block(const BlockPlan& plan, const std::shared_ptr<const Scene>& scene,
                               const Truth& truth, const std::function<void()>& watch);
inline constexpr std::size_t most_trajectories = 60;

/// JSON, every number with all its bits; one line.
[[nodiscard]] std::string to_json(const Block& block, const Scene& scene);
/// Throws InputError for what is no block of this plan, with the pointer of what is wrong: so a window is one
/// that can be run in bounded time, and everything in it exists in the scene. `file` is for messages.
[[nodiscard]] Block parse_block(std::string_view json, const std::string& file, const BlockPlan& plan,
                                const Scene& scene);

}  // namespace flipside::lab::sweep

#pragma once
/// What takes part in a course, and what is noted of it.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lab/regimes/bare_loop.hpp"
#include "world/world.hpp"

namespace flipside::lab::regimes {

/// An engine with its settings, or the bare loop.
struct Kind {
    std::string name;                  ///< as tables have it
    std::string engine;                ///< "": the bare loop
    std::vector<std::string> changes;  ///< of settings, as on the command line
    bool reads = true;                 ///< asks for events and contacts after each step
    bool shown = true;                 ///< in figures at once
};
/// Solvers of our engines, and all others as they come, but for the reference. The bare loop is the first.
[[nodiscard]] std::vector<Kind> kinds();

/// What some steps took, and what they came to.
struct Slice {
    double seconds = 0;  ///< CPU time
    double own = 0;      ///< wall time by the engine's own account, s; 0 where it tells nothing
    double deepest = 0;  ///< overlap at the end, radii of the first ball
    std::uint64_t ball_steps = 0;
};

/// One of a kind on a scene.
class Contender {
  public:
    Contender(const Kind& kind, const std::shared_ptr<const Scene>& scene);

    Slice run(int steps);

    [[nodiscard]] std::size_t balls() const;
    /// Total energy, J; 0 for the bare loop.
    [[nodiscard]] double energy() const;
    /// Null for the bare loop.
    [[nodiscard]] World* world() { return world_.get(); }

  private:
    std::shared_ptr<const Scene> scene_;
    bool reads_;
    std::unique_ptr<World> world_;
    std::optional<BareLoop> bare_;
};

}  // namespace flipside::lab::regimes

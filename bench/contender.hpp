#pragma once
/// What takes part in a row of the benchmark, and what is noted of it.

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bare_loop.hpp"
#include "world/world.hpp"

namespace flipside::bench {

inline constexpr double dt = 1.0 / 60;  // s, of every step

/// An engine with its settings, or the bare loop, on a scene.
class Contender {
  public:
    struct Kind {
        std::string name;                  ///< as the table has it
        std::string engine;                ///< "": the bare loop
        std::vector<std::string> changes;  ///< of settings, as on the command line
        bool reads = true;                 ///< asks for events and contacts after each step
    };
    Contender(const Kind& kind, const std::shared_ptr<const Scene>& scene);

    /// Makes so many steps. Their time counts if `timed`.
    void run(int steps, bool timed);

    /// CPU time per ball and step, ns.
    [[nodiscard]] double nanoseconds() const { return 1e9 * seconds_ / static_cast<double>(ball_steps_); }
    /// What the engine itself says that its step took, wall time per ball and step, ns; 0 where it does not.
    [[nodiscard]] double own_nanoseconds() const {
        return 1e9 * own_seconds_ / static_cast<double>(ball_steps_);
    }
    /// Deepest overlap at the end of any slice that counted, radii of the first ball.
    [[nodiscard]] double deepest() const { return deepest_; }
    [[nodiscard]] std::size_t lost() const;
    [[nodiscard]] std::size_t asleep() const;
    /// Relative change of the energy since the steps began to count.
    [[nodiscard]] double drift() const;
    /// Null for the bare loop.
    [[nodiscard]] World* world() { return world_.get(); }

  private:
    std::shared_ptr<const Scene> scene_;
    bool reads_;
    std::unique_ptr<World> world_;
    std::optional<BareLoop> bare_;
    double seconds_ = 0, own_seconds_ = 0, deepest_ = 0, first_energy_ = 0;
    std::size_t first_balls_ = 0;
    std::uint64_t ball_steps_ = 0;
};

}  // namespace flipside::bench

#pragma once
/// What the checks of the items share.

#include <cmath>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "lab/conformance/conformance.hpp"
#include "plugin/engine.hpp"

namespace flipside::lab {

/// What a check found.
struct Finding {
    Grade grade = Grade::fail;
    std::string says;
    double share = 1;  ///< of the points, where it is in part
};
[[nodiscard]] Finding passes(std::string says);
[[nodiscard]] Finding fails(std::string says);
/// Full points up to `good`, in proportion to the logarithm from there to `bound`, none above.
[[nodiscard]] Finding graded(double error, double good, double bound, std::string says);

/// The engine that is checked.
class Subject {
  public:
    explicit Subject(const plugin::Plugin& plugin) : plugin_(plugin) {}

    [[nodiscard]] const Engine& engine() const { return plugin_.engine; }
    [[nodiscard]] const plugin::Description& description() const { return plugin_.description; }
    [[nodiscard]] bool declares(std::uint64_t features) const {
        return (plugin_.description.features & features) == features;
    }
    /// The scene has bounds of 10 m; `rest` is its other keys.
    [[nodiscard]] std::unique_ptr<World> world(const std::string& rest) const;
    [[nodiscard]] std::shared_ptr<const Scene> scene(const std::string& rest) const;
    /// A part at y = 0 that a ball can fall on, of a kind of primitive that the engine declares; "" where it
    /// declares none. `more` are further keys of it.
    [[nodiscard]] std::string floor(const std::string& more = "") const;

  private:
    const plugin::Plugin& plugin_;
};

/// Equal steps for so many seconds, with a callback after each.
template <class See>
void run_for(World& world, double seconds, double dt, See&& see) {
    const long steps = std::lround(seconds / dt);
    for (long i = 0; i < steps; ++i) {
        world.step(dt);
        see();
    }
}

struct ContractItem {
    const char* name;
    const char* asks;
    int points;
    std::uint64_t needs;  ///< features without which it is not offered
    bool mandatory;
    Finding (*check)(const Subject& subject);
};
/// In the order in which they are asked; each family in a file of its own.
[[nodiscard]] std::span<const ContractItem> motion_items();
[[nodiscard]] std::span<const ContractItem> surface_items();
[[nodiscard]] std::span<const ContractItem> contract_items();

}  // namespace flipside::lab

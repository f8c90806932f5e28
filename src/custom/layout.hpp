#pragma once
/// The primitives of the table, prepared for the step: the still ones first, then the moving ones. So the
/// index of a primitive is also its handle in the broad phase; the handles of balls follow.

#include <span>

#include "custom/broad_phase/broad_phase.hpp"
#include "custom/geometry/narrow_phase.hpp"

namespace flipside::custom {

using PrimitiveIndex = std::uint32_t;

class Layout {
  public:
    explicit Layout(const Scene& scene);

    [[nodiscard]] const Primitive& primitive(PrimitiveIndex i) const { return primitives_[i]; }
    [[nodiscard]] std::span<const Primitive> primitives() const { return primitives_; }
    [[nodiscard]] PrimitiveIndex size() const { return static_cast<PrimitiveIndex>(primitives_.size()); }
    /// Whether a primitive collides with a ball now. Sensors, targets that are down, and gates that let the
    /// ball through (gate.hpp) do not. Cheap for most primitives.
    [[nodiscard]] bool should_collide(const Table& table, PrimitiveIndex i, const Pose& pose,
                                      const Ball& ball) const;
    /// Proxies of the still primitives, by index.
    [[nodiscard]] const std::vector<Proxy>& still_proxies() const { return still_proxies_; }
    /// Indices of the parts that are gates.
    [[nodiscard]] std::span<const PartIndex> gates() const { return gates_; }

    /// Fills `moving` with the proxies of the moving primitives, `ahead` seconds after the table's time, then
    /// of the balls. Their boxes reach `margin` radii beyond them.
    void fill_proxies(const Table& table, std::span<const Ball> balls, double ahead, double margin,
                      std::vector<Proxy>& moving) const;

    /// Restitution, friction and kick between a ball and a ball or part.
    [[nodiscard]] Mixed mixed(const Ball& ball, const auto& other) const {
        return mix(scene_.materials[ball.material], scene_.materials[other.material]);
    }

  private:
    [[nodiscard]] Proxy proxy_of(const Primitive& primitive, const Pose& pose = {}) const;

    const Scene& scene_;
    std::vector<Primitive> primitives_;
    PrimitiveIndex still_ = 0;
    std::vector<Proxy> still_proxies_;
    std::vector<PartIndex> gates_;
    std::vector<char> always_collides_;  ///< per primitive: no part of a sensor, target or gate
};

}  // namespace flipside::custom

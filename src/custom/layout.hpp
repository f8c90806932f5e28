#pragma once
/// The primitives of the table made ready for the step: the still ones first, then the moving ones, so that a
/// primitive's index is also its handle in the broad phase; balls have the handles after them.

#include <span>

#include "custom/broad_phase/broad_phase.hpp"
#include "custom/geometry/narrow_phase.hpp"

namespace flipside::custom {

using PrimitiveIndex = std::uint32_t;

/// Whether a primitive answers a ball now: no sensor, no target that is down, no gate that lets this ball
/// through (gate.hpp).
[[nodiscard]] bool stops(const Table& table, const Primitive& primitive, const Pose& pose, const Ball& ball);

class Layout {
  public:
    explicit Layout(const Scene& scene);

    [[nodiscard]] const Primitive& primitive(PrimitiveIndex i) const { return primitives_[i]; }
    [[nodiscard]] std::span<const Primitive> primitives() const { return primitives_; }
    [[nodiscard]] PrimitiveIndex size() const { return static_cast<PrimitiveIndex>(primitives_.size()); }
    [[nodiscard]] bool moves(PrimitiveIndex i) const { return i >= still_; }
    /// Pose and rate (rad/s) of a primitive `ahead` seconds from now; cheap for what is still.
    [[nodiscard]] Pose pose(const Table& table, PrimitiveIndex i, double ahead) const {
        return moves(i) ? table.pose(primitives_[i].part, ahead) : Pose{};
    }
    [[nodiscard]] double rate(const Table& table, PrimitiveIndex i, double ahead) const {
        return moves(i) ? table.rate(primitives_[i].part, ahead) : 0;
    }
    /// Whether it is no sensor, target or gate.
    [[nodiscard]] bool always_stops(PrimitiveIndex i) const { return always_stops_[i]; }
    /// The same as stops() above; cheap for most primitives.
    [[nodiscard]] bool stops(const Table& table, PrimitiveIndex i, const Pose& pose, const Ball& ball) const {
        return always_stops_[i] || custom::stops(table, primitives_[i], pose, ball);
    }
    /// Of the still primitives, by index.
    [[nodiscard]] const std::vector<Proxy>& still_proxies() const { return still_proxies_; }
    /// Parts that are gates.
    [[nodiscard]] std::span<const PartIndex> gates() const { return gates_; }

    /// Proxies of the moving primitives and then of the balls. Primitives cover their way from `begin` to
    /// `end` seconds from the table's now. `box_of` gives the box of a ball; it is active unless asleep
    /// and `all_active` is false. A primitive is active when it turns meanwhile.
    void place(const Table& table, std::span<const Ball> balls, double begin, double end, bool all_active,
               auto&& box_of, std::vector<Proxy>& moving) const {
        moving.clear();
        for (PrimitiveIndex i = still_; i < primitives_.size(); ++i)
            moving.push_back(proxy(table, i, begin, end));
        for (const Ball& ball : balls)
            moving.push_back(
                {box_of(ball), ball.layer, ball.collides_with, true, all_active || !ball.asleep});
    }

    /// What happens between two materials.
    [[nodiscard]] const Mixed& mixed(std::uint32_t a, std::uint32_t b) const {
        return mixed_[a * materials_ + b];
    }

    [[nodiscard]] const Mixed& mixed(const Ball& ball, PrimitiveIndex i) const {
        return mixed(ball.material, material_of_[i]);
    }

    /// Of a moving primitive, as in place().
    [[nodiscard]] Proxy proxy(const Table& table, PrimitiveIndex i, double begin, double end) const;

  private:
    const Scene& scene_;
    std::vector<Primitive> primitives_;
    PrimitiveIndex still_ = 0;
    std::vector<Proxy> still_proxies_;
    std::vector<PartIndex> gates_;
    std::vector<char> always_stops_;          ///< per primitive
    std::vector<std::uint32_t> material_of_;  ///< per primitive
    std::size_t materials_;
    std::vector<Mixed> mixed_;
};

}  // namespace flipside::custom

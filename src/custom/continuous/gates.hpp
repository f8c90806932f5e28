#pragma once
/// Sensors and gates: which balls are inside them, and whether a gate lets a ball through. A sensor only
/// records balls. A gate blocks a ball that comes from its far side; it opens for one that comes from the
/// other side, and is then open for all balls until the last one has left it.

#include <span>
#include <vector>

#include "custom/continuous/simulation.hpp"

namespace flipside::custom {

class Gates {
  public:
    explicit Gates(Simulation& sim);

    /// Finds which of these balls are inside sensors from their positions, where the table's memory does not
    /// tell.
    void find_sensed(std::span<const Ball> balls);
    /// Decides for each ball that overlaps a gate at the start of the window whether the gate lets it
    /// through: such a ball had no impact event with the gate.
    void settle();

    /// Whether a ball is inside a sensor, or inside a gate that lets it through.
    [[nodiscard]] bool inside(BallNumber ball, PartIndex part) const;
    void set_inside(BallNumber ball, PartIndex part, bool inside) {
        set_listed(list(), {ball, part}, inside);
    }
    [[nodiscard]] bool any_inside() const { return !list().empty(); }
    [[nodiscard]] bool any_inside(PartIndex part) const;
    /// The sensors and gates around a ball.
    [[nodiscard]] std::span<const Sensed> around(BallNumber ball) const;

    /// Whether the feature does not collide with the ball now.
    [[nodiscard]] bool ignores(const Feature& feature, const Ball& ball) const;
    /// The primitives that do not ignore the ball and whose features overlap the box. Valid until the next
    /// call.
    [[nodiscard]] std::span<const PrimitiveIndex> primitives_near(const Box& box, const Ball& ball);
    /// Distance of a ball's surface from a part, m; negative inside.
    [[nodiscard]] double distance_to(PartIndex part, Vec2 center, double radius, const Pose& pose) const;
    /// Whether the gate lets a ball through that touches it.
    [[nodiscard]] bool lets_through(PartIndex part, const Ball& ball, double time) const;
    /// Time at which a ball on this path enters a sensor, or leaves a sensor or gate; never_touch if not
    /// before `last`, which the search passes by one step at most. Conservative advancement with a bound on
    /// the speed, in steps of at least sense_step or a 100,000th of the interval, and then first_zero(). A
    /// contact shallower than such a step may be missed.
    [[nodiscard]] double sense_time(PartIndex part, const Ball& ball, const Path& path, double time,
                                    double last, bool inside) const;

  private:
    [[nodiscard]] std::vector<Sensed>& list() const { return sim_.table.memory().inside; }

    Simulation& sim_;
    std::vector<PrimitiveIndex> first_;  ///< per part: its first primitive; the others follow it
    std::vector<PrimitiveIndex> near_;   ///< buffer of primitives_near()
};

}  // namespace flipside::custom

#pragma once
/// How long a ball surely flies free. What is told is kept by the solver as a certificate: until it runs out
/// the ball needs no search at all, and a search would have found nothing, so results do not depend on it.
///
/// Between two instants a flight stays within k·t²/8 of the chord between them (k: greatest acceleration).
/// The chord, made so much thicker and by the ball's radius and a margin, is tested against convex obstacles
/// by separating axes. To one that is not clear of it the flight is followed by conservative advancement
/// (Mirtich 1996, "Impulse-based dynamic simulation of rigid body systems"): the ball stays on its side of
/// the line across the way to the nearest point until its speed and gravity may take it there; from then on
/// the rest of the flight is tested again.
///
/// A part that stands still is its pieces where they are. One that turns is the disc of all places that it
/// can reach: certificates hold as long as no part starts to turn. Sensors, open gates and targets that are
/// down are in the way like everything else.

#include <span>
#include <vector>

#include "custom/broad_phase/box_index.hpp"
#include "custom/continuous/time_of_impact.hpp"
#include "custom/flight.hpp"
#include "custom/geometry/bounds.hpp"
#include "custom/layout.hpp"

namespace flipside::custom {

/// Balls are told to fly free only where they stay so far from everything, m: well over what any touch or
/// rounding counts as contact.
[[nodiscard]] inline double clearance_margin(const Ball& ball) {
    return 1e-3 * ball.radius + joint_distance +
           1e-12 * (std::abs(ball.position.x) + std::abs(ball.position.y));
}

class Clearance {
  public:
    Clearance(const Scene& scene, const Layout& layout, const Table& table);

    /// Takes over where the moving parts are. True if one has left the place where it stood: then what was
    /// told before does not hold any more.
    bool follow(std::span<const Turning> turnings);

    /// Whether a box touches what a turning part can reach.
    [[nodiscard]] bool beside_turning(const Box& box) const;

    /// For how long, up to `longest`, a ball on this flight surely stays clear of all obstacles and inside
    /// the bounds of the scene: followed until it gains no more than `finest` by an advance, s. Cost: a box
    /// test per obstacle nearby, and about 30 ns per advance to one in the way. Tests made are added to the
    /// two counts.
    [[nodiscard]] double free_for(const Ball& ball, const Flight& flight, double longest, double finest,
                                  std::uint64_t& box_tests, std::uint64_t& shape_tests);

  private:
    /// All points with low ≤ normal·p ≤ high.
    struct Slab {
        Vec2 normal;  ///< unit
        double low = -INFINITY, high = INFINITY;
    };
    /// Everything within `radius` of the hull of some points; the hull lies within some slabs.
    struct Obstacle {
        std::uint32_t first_slab = 0, slabs = 0;
        std::uint32_t first_point = 0, points = 0;
        double radius = 0;
        bool hollow = false;  ///< only the circle itself
        std::uint32_t layer = 1, collides_with = ~0U;
    };
    /// A part of a flight between two instants.
    struct Chord {
        Vec2 a, b;
        double reach = 0;  ///< m, of the ball from the chord
    };

    // For how long something surely holds, s.
    [[nodiscard]] double surely_inside(const Box& bounds, double longest) const;
    [[nodiscard]] double surely_apart(const Obstacle& obstacle, Vec2 at, Vec2 velocity, double longest) const;
    [[nodiscard]] double surely_within(Vec2 at, Vec2 velocity, double radius, double longest) const;

    void place(std::size_t index, const Piece& piece, const Pose& pose);
    void enclose(const Obstacle& obstacle);
    [[nodiscard]] bool apart(const Obstacle& obstacle, const Chord& chord) const;
    [[nodiscard]] Vec2 nearest_point(const Obstacle& obstacle, Vec2 at) const;
    [[nodiscard]] double clear_until(const Obstacle& obstacle, double until, Vec2 at_until);

    struct Moving {
        PartIndex part = 0;
        bool turns = false;
        double angle = 0;
        std::uint32_t first = 0, last = 0;  ///< its pieces among the obstacles; then its disc
        Box disc;
    };
    void take_over(const Moving& moving, const Pose& pose, std::size_t disc);

    const Scene& scene_;
    const Layout& layout_;
    std::vector<Obstacle> obstacles_;  ///< of pieces in their order, then of what moving parts can reach
    BoxIndex boxes_;                   ///< of obstacles; nowhere while they do not count
    std::vector<Slab> slabs_;
    std::vector<Vec2> points_;
    std::vector<Moving> moving_;

    // Of the flight that is followed.
    const Flight* flight_ = nullptr;
    double reach_ = 0, finest_ = 0;
    double bend_ = 0, slowed_ = 0;  ///< greatest acceleration, and by drag alone, m/s²
    std::uint64_t shape_tests_ = 0;
    std::vector<std::uint32_t> in_the_way_;
};

}  // namespace flipside::custom

#pragma once
/// Balls that press on each other: all contacts of a pile are solved together, once per flight.
///
/// Sought are impulses that only push, such that no contact closes: sequential impulses with a running
/// total per contact (Catto 2005, "Iterative dynamics with temporal coherence"), from the lowest contact to
/// the highest, drawn on along conjugate directions (Silcowitz, Niebe, Erleben 2010, "A nonsmooth nonlinear
/// conjugate gradient method for interactive contact force problems"), begun from the forces between balls
/// in the flight before. Those forces are part of a world's State.
///
/// A force that lasts moves a ball by half the flight times what it changes its velocity by. So what rests
/// stays where it is to rounding, and what slides is driven as it should be; nothing has to be pushed out.
///
/// Its approximation, the *unfinished pile*: the rounds are limited. A contact that still closes after them
/// stops the upper ball as if the lower had infinite mass, from the lowest to the highest (shock
/// propagation: Guendelman, Bridson, Fedkiw 2003, "Nonconvex rigid bodies with stacking"). Overlap that is
/// left is taken out of positions, never put into velocities, and a ball that is lifted by that pays for
/// it with its speed. So the energy that a step adds is at most weight × overlap, of balls that had no
/// speed left to pay with. In a pile that is at rest all of this is below rounding.
///
/// Cost per flight: a sort of the contacts by height, and (rounds + passes) × contacts; at rest one round.

#include <span>
#include <vector>

#include "custom/geometry/narrow_phase.hpp"
#include "world/ball.hpp"

namespace flipside::custom {

class Pile {
  public:
    /// What acted between two bodies during the flight, N·s on the first: along the normal, and along
    /// perp(normal).
    struct Impulse {
        double normal = 0, tangent = 0;

        friend Impulse operator+(const Impulse& x, const Impulse& y) {
            return {x.normal + y.normal, x.tangent + y.tangent};
        }
        friend Impulse operator-(const Impulse& x, const Impulse& y) {
            return {x.normal - y.normal, x.tangent - y.tangent};
        }
        friend Impulse operator*(double s, const Impulse& x) { return {s * x.normal, s * x.tangent}; }
    };

    /// Makes room for so many balls.
    void reserve(std::size_t balls);
    /// Empties it. The balls have flown for `duration` seconds under `gravity` (m/s², not 0); they are
    /// changed by solve().
    void start(std::span<Ball> balls, Vec2 gravity, double duration);
    /// Takes a ball (by place) in. All come in before the first contact.
    void join(std::uint32_t place);
    /// A ball that joined on a part whose surface moves at `surface` m/s.
    void add(std::uint32_t place, const Touch& touch, Vec2 surface, double friction);
    /// Two balls that joined, not both asleep, with the impulse from which to begin; it acts on a along the
    /// normal from b to a.
    void add(std::uint32_t a, std::uint32_t b, double friction, const Impulse& begin);
    /// Moves the balls to what their contacts leave of their flight.
    void solve();
    /// Per contact, in the order in which they were added.
    [[nodiscard]] std::span<const Impulse> impulses() const { return impulses_; }

  private:
    using Index = std::uint32_t;
    struct Body {
        Vec2 velocity;
        double spin = 0, radius = 0;
        double per_mass = 0, per_inertia = 0;  ///< 0 for parts and sleepers
    };
    struct Contact {
        Index upper = 0, lower = 0;  ///< bodies
        Index number = 0;            ///< in the order of adding
        Vec2 normal;                 ///< from lower to upper
        double allowed = 0;  ///< m/s, speed of approach that only closes the gap until the next flight ends
        double friction = 0;
        double mass = 0, rim_mass = 0;  ///< kg, against impulses along the normal and the tangent
        Impulse total;
    };
    /// Of a contact in the conjugate gradient method.
    struct Direction {
        Impulse before, along;
    };
    /// Where a ball was on a part, and how far off; of bodies that are parts.
    struct Ground {
        Vec2 position;
        double gap = 0;
    };

    void order();
    void push(const Contact& contact, const Impulse& impulse);
    double correct(Contact& contact);
    double one_round();
    void run_on(double& norm_before);
    void brace();
    void take_over();
    bool separate(const Contact& contact);
    void separate();

    std::span<Ball> balls_;
    Vec2 gravity_;
    double duration_ = 0;
    std::vector<Index> members_;  ///< per place: the body, of balls that joined
    std::vector<Index> places_;   ///< and back
    std::vector<Body> bodies_;    ///< balls, then a part per contact with one
    std::vector<Ground> grounds_;
    std::vector<Contact> added_, contacts_;  ///< contacts_ from the lowest to the highest
    std::vector<Direction> directions_;
    std::vector<Impulse> impulses_;
    std::vector<Vec2> positions_;
    struct Height {
        double height;
        Index contact;
        friend auto operator<=>(const Height&, const Height&) = default;
    };
    std::vector<Height> heights_;
};

}  // namespace flipside::custom

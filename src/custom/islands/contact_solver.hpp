#pragma once
/// Balls that press on each other, over one tick: all contacts are solved together.
///
/// Sought are impulses that only push, such that after the tick no gap is negative: the velocity with which
/// a ball ends the tick is also the one with which it moves through it (symplectic Euler), so a contact with
/// a gap d may close at d/h and no faster. Solved by projected Gauss-Seidel with a running total per contact,
/// begun from the impulses of the tick before (Catto 2005, "Iterative dynamics with temporal coherence"),
/// from the lowest contact to the highest. Friction is Coulomb's, with the pushes of the same sweep.
///
/// Approximations: the *unfinished solve*, the number of sweeps is limited, and what then still overlaps is
/// moved apart (by position only; a ball that is lifted by that pays with its speed); and within a tick
/// forces do not change.
///
/// Cost per tick: a sort of the contacts by height, and sweeps × contacts.

#include <cstdint>
#include <span>
#include <vector>

#include "world/vec2.hpp"

namespace flipside::custom {

/// Impulses between two bodies, N·s on the upper: along the normal, and along perp(normal).
struct ContactImpulse {
    double normal = 0, tangent = 0;

    friend ContactImpulse operator+(const ContactImpulse& x, const ContactImpulse& y) {
        return {x.normal + y.normal, x.tangent + y.tangent};
    }
    friend ContactImpulse operator-(const ContactImpulse& x, const ContactImpulse& y) {
        return {x.normal - y.normal, x.tangent - y.tangent};
    }
    friend ContactImpulse operator*(double s, const ContactImpulse& x) {
        return {s * x.normal, s * x.tangent};
    }
};

class ContactSolver {
  public:
    using Index = std::uint32_t;

    struct Body {
        Vec2 position, velocity;  ///< at the tick's start
        Vec2 driven;              ///< what gravity and drag will change the velocity by, m/s
        double spin = 0, radius = 0;
        double per_mass = 0, per_inertia = 0;  ///< 0 for what does not move
    };
    /// What a ball may press on, in the order in which contacts are solved.
    enum class With : std::uint8_t { still_part, moving_part, ball };
    struct Contact {
        Index upper = 0, lower = 0;  ///< the normal points from lower to upper
        With with = With::ball;
        bool bounces = false;  ///< is met too fast to press: an event will see to it
        Vec2 normal;
        double friction = 0;  ///< µ
        ContactImpulse impulse;

        // Found by solve().
        double closing = 0;             ///< m/s, at most allowed
        double mass = 0, rim_mass = 0;  ///< against an impulse along the normal, and across it
        double per_mass = 0, per_rim_mass = 0;
        ContactImpulse before, along;  ///< before the last sweep; direction in which to run on

        double gap_found = 0;        ///< m, when it was found
        double height = 0;           ///< m, against gravity
        std::uint32_t a = 0, b = 0;  ///< by which its force is remembered
        double gap = 0;              ///< m, when all that overlapped was moved apart; by solve()
        Vec2 found_at;               ///< of the upper body; by solve()
    };

    void reserve(std::size_t balls);
    void start() { bodies_.clear(), contacts_.clear(); }
    Index add(const Body& body) {
        bodies_.push_back(body);
        return static_cast<Index>(bodies_.size() - 1);
    }
    void add(const Contact& contact) { contacts_.push_back(contact); }

    /// Finds the velocities and spins after `duration` seconds; positions change by as much as bodies
    /// overlap.
    void solve(double duration, Vec2 gravity);

    [[nodiscard]] std::span<const Body> bodies() const { return bodies_; }
    /// The greatest change of a velocity in each sweep of the last solve, m/s.
    [[nodiscard]] std::span<const double> residuals() const { return residuals_; }
    /// In the order in which they were solved.
    [[nodiscard]] std::span<const Contact> contacts() const { return contacts_; }

  private:
    /// Of a sweep.
    struct Progress {
        double most = 0;  ///< change of a velocity, m/s
        double norm = 0;  ///< square of what it and the run before it got on
    };
    void push(const Contact& contact, const ContactImpulse& impulse);
    void correct(Contact& contact);
    Progress sweep();
    [[nodiscard]] double energy(double ahead, Vec2 gravity) const;
    double move_apart(Contact& contact);
    void move_apart(Vec2 gravity);
    void each_still(auto&& visit);
    void extrapolate(double norm, double norm_before);
    void propagate_shock(const Contact& contact);

    std::vector<Body> bodies_;
    /// By which contacts are put in order.
    struct Place {
        With with = With::ball;
        Index lower = 0, upper = 0, at = 0;
        double height = 0;
    };
    void put_in_order();

    std::vector<Contact> contacts_, unordered_;
    std::vector<Place> places_;
    std::vector<Vec2> moved_from_;
    std::vector<double> residuals_;
};

}  // namespace flipside::custom

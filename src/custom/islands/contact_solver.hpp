#pragma once
/// The island solver: solves all contacts of the islands together over one tick.
///
/// It finds normal impulses ≥ 0 such that no gap is negative after the tick. The velocity at the end of the
/// tick is also the one that moves the ball through it (symplectic Euler), so a contact with a gap d may
/// close at d/h at most. The method is projected Gauss-Seidel with accumulated impulses and warm starting
/// (Catto 2005, "Iterative dynamics with temporal coherence"), from the lowest contact to the highest,
/// with over-relaxation. Coulomb friction uses the normal impulses of the same sweep.
///
/// Approximations: the number of sweeps is limited (*unfinished solve*); overlaps that remain are corrected
/// by position only, and a ball that is lifted by this loses that energy from its speed; forces are constant
/// within a tick.
///
/// Cost per tick: a sort of the contacts by height, and sweeps × contacts.

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "world/state.hpp"

namespace flipside::custom {

/// Impulses between two bodies, N·s on the upper: along the normal, and along perp(normal).
struct ContactImpulse {
    double normal = 0, tangent = 0;
};

class ContactSolver {
  public:
    using Index = std::uint32_t;

    struct Body {
        Vec2 position;                ///< m, at the start of the tick
        Vec2 velocity;                ///< m/s, at the start of the tick
        Vec2 external;                ///< m/s: velocity change by gravity and drag in the tick
        double rim_speed = 0;         ///< m/s: spin times radius
        double radius = 0;            ///< m
        double inverse_mass = 0;      ///< 1/kg; 0 for static bodies
        double inverse_rim_mass = 0;  ///< 1/kg: radius²/inertia; 0 for static bodies
    };
    /// The lower body of a contact, in the order in which contacts are solved.
    enum class With : std::uint8_t { still_part, moving_part, ball };
    struct Contact {
        Index upper = 0, lower = 0;  ///< the normal points from lower to upper
        With with = With::ball;
        bool bounces = false;  ///< approaches too fast: the impact is an event, not part of the solve
        Vec2 normal;
        double friction = 0;  ///< µ
        ContactImpulse impulse{};

        // Set by solve().
        double max_closing = 0;                    ///< m/s, allowed closing speed
        double normal_mass = 0, tangent_mass = 0;  ///< effective masses along the normal and across it, kg

        double detected_gap = 0;     ///< m, at the start of the tick
        double height = 0;           ///< potential by which contacts are sorted, m²/s²
        std::uint32_t a = 0, b = 0;  ///< key in the force cache
        double gap = 0;              ///< m, after the position correction; set by solve()
    };

    void reserve(std::size_t balls);
    void start() { bodies_.clear(), contacts_.clear(); }
    Index add(const Body& body) {
        bodies_.push_back(body);
        return static_cast<Index>(bodies_.size() - 1);
    }
    void add(const Contact& contact) { contacts_.push_back(contact); }

    /// Finds the velocities and spins after `duration` seconds. Corrects the positions of overlapping bodies.
    void solve(double duration, Vec2 gravity);

    [[nodiscard]] std::span<const Body> bodies() const { return bodies_; }
    /// The greatest change of a velocity in each sweep of the last solve, m/s.
    [[nodiscard]] std::span<const double> residuals() const { return residuals_; }
    /// In the order in which they are solved.
    [[nodiscard]] std::span<const Contact> contacts() const { return contacts_; }

  private:
    double solve_contact(Contact& contact, double relaxation);
    bool converge(std::span<Contact> contacts, int most, double relaxation, double enough);
    void converge_squeezed(double enough);
    [[nodiscard]] double energy(double ahead, Vec2 gravity) const;
    double correct_position(Contact& contact, bool by_mass);
    double correct_positions(Vec2 gravity);
    void limit_corrections();
    void repeat_static(double enough, auto&& correct);
    double propagate_shock(const Contact& contact);

    std::vector<Body> bodies_;
    std::vector<Contact> contacts_;
    std::vector<Vec2> uncorrected_;  ///< per body: its position before the correction
    std::vector<int> reached_;       ///< per body; see converge_squeezed()
    std::vector<Contact> squeezed_;
    std::vector<double> residuals_;
};

/// The contact forces of the previous tick, from which a solve starts (warm starting). Sorted by ball.
class ForceCache {
  public:
    void reserve(std::size_t forces) { forces_.reserve(forces), merged_.reserve(forces); }
    void clear() { forces_.clear(), sorted_ = 0; }

    /// Removes the forces for which `holds` is true.
    void forget_if(auto&& holds) {
        std::erase_if(forces_, holds);
        sorted_ = forces_.size();
    }
    /// Adds a force; find() sees it after merge().
    void add(const ContactForce& force) { forces_.push_back(force); }
    /// Merges the new forces into the sorted ones. Cost: a sort of the new ones, and one pass.
    void merge() {
        const auto middle = forces_.begin() + static_cast<std::ptrdiff_t>(sorted_);
        std::ranges::sort(middle, forces_.end(), {}, rank);
        merged_.clear();
        std::ranges::merge(forces_.begin(), middle, middle, forces_.end(), std::back_inserter(merged_), {},
                           rank, rank);
        std::swap(forces_, merged_);
        sorted_ = forces_.size();
    }

    /// The force between a and b, or null if there was none. Cost: a binary search.
    [[nodiscard]] const ContactForce* find(std::uint32_t a, std::uint32_t b) const {
        const auto force = std::ranges::lower_bound(forces_, rank({a, b}), {}, rank);
        return force != forces_.end() && force->b == b && force->a == a ? &*force : nullptr;
    }
    /// Sorted by `b`, then `a`.
    [[nodiscard]] std::span<const ContactForce> all() const { return forces_; }

  private:
    /// A function object, which is inlined where a function pointer is called.
    static constexpr auto rank = [](const ContactForce& force) {
        return std::uint64_t{force.b} << 32 | force.a;
    };

    std::vector<ContactForce> forces_;  ///< the sorted forces, then the new ones
    std::vector<ContactForce> merged_;  ///< buffer of merge()
    std::size_t sorted_ = 0;
};

}  // namespace flipside::custom

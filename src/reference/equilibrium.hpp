#pragma once
/// Whether discs that touch can stay at rest, and by which contact forces.
///
/// In the plane Coulomb's cone has two edges, so a contact force is a·(n + µt) + b·(n − µt) with a, b ≥ 0,
/// and equilibrium is a non-negative solution of linear equations: two forces and a torque for each disc. It
/// is found by non-negative least squares (Lawson and Hanson 1974, "Solving Least Squares Problems", chapter
/// 23) on a QR factorisation that columns are added to and removed from. Cost: 3n rows by as many columns for
/// each force that is tried, about n³ in all.
///
/// A heap that is statically indeterminate has many solutions; any will do, as rest is then one of the
/// motions that the laws allow (without friction the only one). If there is no solution, the
/// residual of the weights is a motion that violates no contact and in which the weights do work (Farkas'
/// lemma).

#include <cstdint>
#include <span>
#include <vector>

#include "world/vec2.hpp"

namespace flipside::reference {

/// Contact forces balance the weight of every disc to this share of it, in force and in torque over radius.
constexpr double balance_tolerance = 1e-10;

/// A contact of a disc with another disc or with a static part.
struct Support {
    static constexpr std::uint32_t fixed = ~0U;
    std::uint32_t disc = 0, other = fixed;  ///< indices of discs
    Vec2 normal;                            ///< unit, to the disc
    double friction = 0;                    ///< µ
    double normal_force = 0;                ///< N, ≥ 0
    double friction_force = 0;              ///< N, on the disc along perp(normal)
};

/// The residual of the forces that were found.
struct Imbalance {
    double share = 0;        ///< of the weight of the disc, the largest
    std::uint32_t disc = 0;  ///< whose that is
};

/// Sets the forces of all supports so that they balance the weights (N, of each disc) as well as they can.
[[nodiscard]] Imbalance find_equilibrium(std::span<const Vec2> weights, std::span<Support> supports);

}  // namespace flipside::reference

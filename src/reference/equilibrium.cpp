#include "reference/equilibrium.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace flipside::reference {

namespace {

using Numbers = std::vector<double>;

/// A unit force along an edge of a friction cone, with its effect on both discs.
struct Edge {
    std::size_t support = 0;
    double side = 0;  ///< of the edge n + side·µt; 0 without friction
    std::array<std::pair<std::size_t, double>, 6> entries{};  ///< by row
};

double times(const Edge& edge, const Numbers& rows) {
    double sum = 0;
    for (const auto& [row, value] : edge.entries) sum += value * rows[row];
    return sum;
}

/// Q·R of the columns that are in use, with Q row by row.
class Factors {
  public:
    Factors(std::size_t rows, std::size_t most) : most_(most), q_(rows * most), r_(most * most) {}

    /// False for a column that depends on those in use.
    bool append(const Edge& edge) {
        constexpr double dependent = 1e-10;
        Numbers column(q_.size() / most_);
        for (const auto& [row, value] : edge.entries) column[row] += value;
        const double before = norm(column);
        Numbers part(used_);
        for (int pass = 0; pass < 2; ++pass) {  // twice is enough (Kahan and Parlett)
            const Numbers along = project(column);
            for (std::size_t i = 0; i < column.size(); ++i)
                for (std::size_t k = 0; k < used_; ++k) column[i] -= q_[i * most_ + k] * along[k];
            for (std::size_t k = 0; k < used_; ++k) part[k] += along[k];
        }
        const double left = norm(column);
        if (used_ == most_ || !(left > dependent * before)) return false;
        for (std::size_t i = 0; i < column.size(); ++i) q_[i * most_ + used_] = column[i] / left;
        for (std::size_t k = 0; k < used_; ++k) r(k, used_) = part[k];
        r(used_, used_) = left;
        ++used_;
        return true;
    }
    /// Takes out the k-th column; rotations of rows (Givens) make R triangular again.
    void remove(std::size_t k) {
        --used_;
        for (std::size_t j = k; j < used_; ++j)
            for (std::size_t i = 0; i <= j + 1; ++i) r(i, j) = r(i, j + 1);
        for (std::size_t j = k; j < used_; ++j) {
            const double length = std::sqrt(r(j, j) * r(j, j) + r(j + 1, j) * r(j + 1, j));
            const double c = r(j, j) / length, s = r(j + 1, j) / length;
            const auto rotate = [&](double& a, double& b) {
                const double first = c * a + s * b;
                b = c * b - s * a;
                a = first;
            };
            for (std::size_t i = j; i < used_; ++i) rotate(r(j, i), r(j + 1, i));
            for (std::size_t i = 0; i < q_.size(); i += most_) rotate(q_[i + j], q_[i + j + 1]);
        }
    }
    /// Least squares: R⁻¹·Qᵀ·b.
    [[nodiscard]] Numbers solve(const Numbers& b) const {
        Numbers x = project(b);
        for (std::size_t k = used_; k-- > 0;) {
            for (std::size_t j = k + 1; j < used_; ++j) x[k] -= r_[k * most_ + j] * x[j];
            x[k] /= r_[k * most_ + k];
        }
        return x;
    }

  private:
    [[nodiscard]] double& r(std::size_t i, std::size_t j) { return r_[i * most_ + j]; }
    [[nodiscard]] static double norm(const Numbers& v) {
        double sum = 0;
        for (const double one : v) sum += one * one;
        return std::sqrt(sum);
    }
    [[nodiscard]] Numbers project(const Numbers& v) const {
        Numbers along(used_);
        for (std::size_t i = 0; i < v.size(); ++i)
            if (v[i] != 0)
                for (std::size_t k = 0; k < used_; ++k) along[k] += q_[i * most_ + k] * v[i];
        return along;
    }

    std::size_t most_, used_ = 0;
    Numbers q_, r_;
};

/// The search for forces.
class LeastSquares {
  public:
    LeastSquares(std::span<const Vec2> weights, std::span<Support> supports)
        : supports_(supports), target_(3 * weights.size()), factors_(target_.size(), target_.size()) {
        for (std::size_t i = 0; i < weights.size(); ++i) {
            target_[3 * i] = -weights[i].x;
            target_[3 * i + 1] = -weights[i].y;
        }
        for (std::size_t k = 0; k < supports.size(); ++k)
            for (const double side : {1.0, -1.0})
                if (side > 0 || supports[k].friction > 0) edges_.push_back(edge_of(k, side));
        forces_.resize(edges_.size());
        excluded_.resize(edges_.size());
        residual_ = target_;
    }

    Imbalance run() {
        const std::size_t most = 3 * edges_.size();
        for (std::size_t tried = 0; tried < most && imbalance().share > balance_tolerance; ++tried) {
            const std::size_t best = largest_residual();
            if (best == edges_.size()) break;
            excluded_[best] = 1;
            if (!factors_.append(edges_[best])) continue;
            in_use_.push_back(best);
            if (!(solution().back() > 0)) {  // chosen by rounding only
                in_use_.pop_back();
                factors_.remove(in_use_.size());
                continue;
            }
            remove_negative_forces();
            update_residual();
            excluded_.assign(edges_.size(), 0);
        }
        for (Support& support : supports_) support.normal_force = support.friction_force = 0;
        for (std::size_t k = 0; k < edges_.size(); ++k) {
            Support& support = supports_[edges_[k].support];
            support.normal_force += forces_[k];
            support.friction_force += edges_[k].side * support.friction * forces_[k];
        }
        return imbalance();
    }

  private:
    [[nodiscard]] Edge edge_of(std::size_t k, double side) const {
        const Support& support = supports_[k];
        const double rub = side * support.friction;
        const Vec2 force = support.normal + rub * perp(support.normal);
        Edge edge{k, support.friction > 0 ? side : 0, {}};
        const std::size_t a = 3 * std::size_t{support.disc}, b = 3 * std::size_t{support.other};
        edge.entries = {{{a, force.x}, {a + 1, force.y}, {a + 2, rub}, {a, 0}, {a, 0}, {a, 0}}};
        if (support.other != Support::fixed) {
            edge.entries[3] = {b, -force.x};
            edge.entries[4] = {b + 1, -force.y};
            edge.entries[5] = {b + 2, rub};
        }
        return edge;
    }
    /// The unused force with the largest residual along it; none if all are rounding.
    [[nodiscard]] std::size_t largest_residual() const {
        Numbers scale = target_;
        for (double& one : scale) one = std::abs(one);
        for (std::size_t k = 0; k < edges_.size(); ++k)
            for (const auto& [row, value] : edges_[k].entries) scale[row] += std::abs(value) * forces_[k];
        std::size_t best = edges_.size();
        double most = 0;
        for (std::size_t k = 0; k < edges_.size(); ++k) {
            if (excluded_[k] != 0 || forces_[k] > 0) continue;
            double rounding = 0;
            for (const auto& [row, value] : edges_[k].entries) rounding += std::abs(value) * scale[row];
            const double wanted = times(edges_[k], residual_);
            if (wanted <= most || wanted <= 64 * std::numeric_limits<double>::epsilon() * rounding) continue;
            most = wanted;
            best = k;
        }
        return best;
    }
    [[nodiscard]] Numbers solution() const {
        Numbers x = factors_.solve(target_), left = target_;
        for (std::size_t i = 0; i < x.size(); ++i)
            for (const auto& [row, value] : edges_[in_use_[i]].entries) left[row] -= value * x[i];
        const Numbers more = factors_.solve(left);  // iterative refinement
        for (std::size_t i = 0; i < x.size(); ++i) x[i] += more[i];
        return x;
    }
    /// Moves towards the least-squares solution of the forces in use until one becomes zero, removes that
    /// one, and repeats until it reaches the solution.
    void remove_negative_forces() {
        for (;;) {
            const Numbers x = solution();
            double share = INFINITY;
            std::size_t first = x.size();
            for (std::size_t i = 0; i < x.size(); ++i) {
                const double now = forces_[in_use_[i]];
                if (x[i] > 0 || now / (now - x[i]) >= share) continue;
                share = now / (now - x[i]);
                first = i;
            }
            if (first == x.size()) {  // x itself: now + (x - now) could round a tiny force to 0
                for (std::size_t i = 0; i < x.size(); ++i) forces_[in_use_[i]] = x[i];
                return;
            }
            for (std::size_t i = 0; i < x.size(); ++i)
                forces_[in_use_[i]] += share * (x[i] - forces_[in_use_[i]]);
            forces_[in_use_[first]] = 0;
            for (std::size_t i = x.size(); i-- > 0;) {
                if (forces_[in_use_[i]] > 0) continue;
                forces_[in_use_[i]] = 0;
                in_use_.erase(in_use_.begin() + static_cast<std::ptrdiff_t>(i));
                factors_.remove(i);
            }
        }
    }
    void update_residual() {
        residual_ = target_;
        for (std::size_t k = 0; k < edges_.size(); ++k)
            for (const auto& [row, value] : edges_[k].entries) residual_[row] -= value * forces_[k];
    }
    [[nodiscard]] Imbalance imbalance() const {
        Imbalance worst;
        for (std::size_t i = 0; i < target_.size(); i += 3) {
            const double weight = length(Vec2{target_[i], target_[i + 1]});
            for (std::size_t k = i; k < i + 3; ++k) {
                const double share = std::abs(residual_[k]) / weight;
                if (share > worst.share) worst = {share, static_cast<std::uint32_t>(i / 3)};
            }
        }
        return worst;
    }

    std::span<Support> supports_;
    Numbers target_, residual_;  ///< of each disc: forces along x and y, and a torque over its radius, N
    std::vector<Edge> edges_;
    Numbers forces_;                   ///< along the edges, N
    std::vector<std::size_t> in_use_;  ///< the edges that are factored, in order
    std::vector<char> excluded_;       ///< tried without effect since the forces changed last
    Factors factors_;
};

}  // namespace

Imbalance find_equilibrium(std::span<const Vec2> weights, std::span<Support> supports) {
    return LeastSquares(weights, supports).run();
}

}  // namespace flipside::reference

#pragma once
/// Broad phase: finds the pairs of boxes that overlap. It knows boxes and handles, but no shapes.

#include <algorithm>
#include <compare>
#include <memory>
#include <span>
#include <vector>

#include "custom/broad_phase/capacity.hpp"
#include "world/bounds.hpp"
#include "world/inspector.hpp"
#include "world/statistics.hpp"

namespace flipside::custom {

/// Index of a proxy: first the still ones, as given to the constructor, then the moving ones, as given to
/// find_pairs().
using Handle = std::uint32_t;

/// A ball or primitive in the broad phase.
struct Proxy {
    Box box;
    std::uint32_t layer = 1;            ///< one bit
    std::uint32_t collides_with = ~0U;  ///< mask of layers
    bool ball = false;                  ///< a ball, or else part of the table
};

/// Two proxies whose boxes overlap; a < b, so b moves. Ordered by b, then a.
struct Pair {
    Handle a = 0, b = 0;
    friend constexpr bool operator==(const Pair&, const Pair&) = default;
    friend constexpr auto operator<=>(const Pair& x, const Pair& y) {
        return x.b != y.b ? x.b <=> y.b : x.a <=> y.a;
    }
};

inline constexpr std::uint32_t no_cell = ~0U;

/// A cell of a grid, or a node of a tree.
struct Cell {
    Box box;
    int listed = 0;                 ///< number of proxies listed in it, without those below it
    int within = 0;                 ///< the same with those below it
    std::uint32_t index = no_cell;  ///< in the array of the tree; no_cell in a grid
    std::uint32_t parent = no_cell;
    int level = 0;       ///< 0 for the root
    bool leaf = true;    ///< nothing is below it
    bool still = false;  ///< of a tree that holds only still proxies
};

[[nodiscard]] constexpr Vec2 middle_of(const Box& box) {
    return 0.5 * (box.min + box.max);
}
/// The part of the box of a node that belongs to a child: 0 below left, 1 below right, 2 above left, 3 above
/// right.
[[nodiscard]] constexpr Box quarter_of(Box box, std::uint32_t child) {
    const Vec2 middle = middle_of(box);
    (child % 2 == 0 ? box.max.x : box.min.x) = middle.x;
    (child < 2 ? box.max.y : box.min.y) = middle.y;
    return box;
}

/// What a search did, for traces.
struct SearchLog {
    /// A test of one box against another, and whether they overlap.
    struct Test {
        Pair pair;
        bool overlap = false;
        Handle query = 0;              ///< the proxy whose query made the test
        std::uint32_t cell = no_cell;  ///< node of a tree that lists the other proxy
    };
    /// A node of a tree that the query of a proxy visited.
    struct Visit {
        Handle query = 0;
        std::uint32_t cell = no_cell;
        bool still = false;  ///< as in Cell
    };
    std::vector<Test> tests;
    std::vector<Visit> visits;
};

class BroadPhase {
  public:
    explicit BroadPhase(std::vector<Proxy> still)
        : proxies_(std::move(still)), first_moving_(static_cast<Handle>(proxies_.size())) {}
    BroadPhase(const BroadPhase&) = delete;
    BroadPhase& operator=(const BroadPhase&) = delete;
    virtual ~BroadPhase() = default;

    /// Replaces `pairs` by every overlapping pair that may meet, each once, sorted. Pairs of still proxies
    /// are never tested. Allocates only when the input is larger than ever before.
    void find_pairs(std::span<const Proxy> moving, std::vector<Pair>& pairs) {
        reserve_for(proxies_, first_moving_ + moving.size());
        proxies_.resize(first_moving_);
        if (std::ranges::any_of(moving, &Proxy::ball))
            proxies_.insert(proxies_.end(), moving.begin(), moving.end());
        pairs.clear();
        pairs_ = &pairs;
        search();
        std::ranges::sort(pairs);
    }
    /// Number of box tests since the start, including those that building the structure costs.
    [[nodiscard]] std::uint64_t tests() const { return tests_; }
    [[nodiscard]] virtual BroadPhaseFacts facts() const = 0;
    /// The cells of the last search, parents first.
    [[nodiscard]] virtual std::vector<Cell> cells() const { return {}; }
    /// Draws the cells.
    void inspect(Inspector& inspector) const {
        for (const Cell& cell : cells())
            if (cell.leaf && !cell.still) inspector.cell(cell.box, cell.listed);
    }
    /// Adds what searches do to `log` from now on; null stops that.
    void log_searches(SearchLog* log) { log_ = log; }

  protected:
    /// Tests all pairs of moving proxies with all others that may overlap, in any order.
    virtual void search() = 0;
    /// Tests two proxies if one is a ball and their layers meet, and lists them if they overlap. The test
    /// belongs to the query of b, which found a in a cell.
    void test(Handle a, Handle b, std::uint32_t cell = no_cell) {
        const Proxy &of_a = proxies_[a], &of_b = proxies_[b];
        if (!(of_a.ball || of_b.ball) || !layers_meet(of_a, of_b)) return;
        ++tests_;
        const bool overlaps = overlap(of_a.box, of_b.box);
        const Pair pair{std::min(a, b), std::max(a, b)};
        if (overlaps) pairs_->push_back(pair);
        if (log_ != nullptr) log_->tests.push_back({pair, overlaps, b, cell});
    }
    void log_visit(Handle query, std::uint32_t cell, bool still = false) {
        if (log_ != nullptr) log_->visits.push_back({query, cell, still});
    }
    [[nodiscard]] std::size_t moving() const { return proxies_.size() - first_moving_; }

    std::vector<Proxy> proxies_;  ///< by handle
    Handle first_moving_;
    std::uint64_t tests_ = 0;

  private:
    std::vector<Pair>* pairs_ = nullptr;
    SearchLog* log_ = nullptr;
};

struct BroadPhaseOptions {
    Box world;                  ///< m, contains most of the moving boxes
    int quadtree_levels = 4;    ///< 1…8
    int adaptive_capacity = 8;  ///< proxies in a node
    int adaptive_depth = 8;     ///< splits
    double grid_cell = 0;       ///< m, 0: fitted to the boxes
};

using MakeBroadPhase = std::unique_ptr<BroadPhase>(std::vector<Proxy> still,
                                                   const BroadPhaseOptions& options);

/// Tests every pair: n(n−1)/2 for n balls. All other broad phases are tested against it.
MakeBroadPhase make_brute_force;
/// The full quadtree in an array, with quadtree_levels below the root. Boxes outside `world` belong to the
/// cells at the border.
MakeBroadPhase make_quadtree;
/// A quadtree that splits a node of more than adaptive_capacity proxies, at most adaptive_depth times. A box
/// that crosses a split stays in the node above it.
MakeBroadPhase make_adaptive_quadtree;
/// A uniform grid of square cells, grid_cell wide; 0 fits the cells to the moving boxes. Boxes outside
/// `world` belong to the cells at the border. At most 2^22 cells, and 1,024 for each moving box if they are
/// fitted: too small a cell is enlarged.
MakeBroadPhase make_grid;
/// Sweep and prune along x.
MakeBroadPhase make_sweep;

}  // namespace flipside::custom

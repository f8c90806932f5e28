#pragma once
/// Broad phase: finds the pairs of boxes that overlap. It knows boxes and handles, but no shapes.

#include <algorithm>
#include <compare>
#include <memory>
#include <span>
#include <vector>

#include "custom/geometry/bounds.hpp"
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

/// Whether the boxes of two proxies must be tested: one is a ball, and their layers meet.
[[nodiscard]] constexpr bool may_meet(const auto& a, const auto& b) {
    return (a.ball || b.ball) && layers_meet(a, b);
}

/// Two proxies whose boxes overlap; a < b, so b moves. Ordered by b, then a.
struct Pair {
    Handle a = 0, b = 0;
    friend constexpr bool operator==(const Pair&, const Pair&) = default;
    friend constexpr auto operator<=>(const Pair& x, const Pair& y) {
        return x.b != y.b ? x.b <=> y.b : x.a <=> y.a;
    }
};

inline constexpr std::uint32_t no_cell = ~0U;

/// A test of one box against another, and whether they overlap.
struct PairTest {
    Pair pair;
    bool overlap = false;
    Handle query = 0;              ///< the proxy whose query made the test
    std::uint32_t cell = no_cell;  ///< node of a tree that lists the other proxy
};

/// A node of a quadtree, for traces.
struct Cell {
    Box box;
    int listed = 0;                  ///< number of proxies listed in it, without those below it
    std::uint32_t index = no_cell;   ///< in the array of the tree
    std::uint32_t parent = no_cell;  ///< no_cell for the root
    int level = 0;                   ///< 0 for the root
    bool still = false;              ///< whether its tree holds only still proxies
};

/// Indices of the nodes that the query of one proxy visits.
struct Visited {
    std::vector<std::uint32_t> cells, still_cells;
};

class BroadPhase {
  public:
    explicit BroadPhase(std::vector<Proxy> still) : still_(std::move(still)) {}
    BroadPhase(const BroadPhase&) = delete;
    BroadPhase& operator=(const BroadPhase&) = delete;
    virtual ~BroadPhase() = default;

    /// Replaces `pairs` by every overlapping pair that may meet, each once, sorted. Pairs of still proxies
    /// are never tested. Allocates only when the input is larger than ever before.
    void find_pairs(std::span<const Proxy> moving, std::vector<Pair>& pairs) {
        pairs.clear();
        pairs_ = &pairs;
        moving_ = std::ranges::any_of(moving, &Proxy::ball) ? moving : std::span<const Proxy>{};
        search();
        std::ranges::sort(pairs);
    }
    /// Number of box tests since the start, including those that building the structure costs.
    [[nodiscard]] std::uint64_t tests() const { return tests_; }
    [[nodiscard]] virtual BroadPhaseFacts facts() const = 0;
    /// Adds every box test of two proxies to `log` from now on; null stops that.
    void log_tests(std::vector<PairTest>* log) { log_ = log; }
    /// Draws the cells of the last find_pairs().
    virtual void inspect(Inspector&) const {}
    /// For traces: the nodes of the last find_pairs() that have proxies at or below them, parents first.
    /// Empty if there is no tree.
    [[nodiscard]] virtual std::vector<Cell> tree() const { return {}; }
    /// For traces: the nodes that the query of a moving proxy visits, by its handle. Cost: linear in the
    /// tree.
    [[nodiscard]] virtual Visited visited(Handle) const { return {}; }

  protected:
    /// Tests all pairs of moving_ with still_ and among each other that may overlap, in any order.
    virtual void search() = 0;
    /// Tests a still and a moving proxy, by their indices, and lists them if they overlap. The test belongs
    /// to the query of b, which found a in a cell.
    void test_still(Handle a, Handle b, std::uint32_t cell = no_cell) {
        test(a, still_[a], handle_of(b), moving_[b], cell);
    }
    /// The same for two moving proxies.
    void test_moving(Handle a, Handle b, std::uint32_t cell = no_cell) {
        test(handle_of(a), moving_[a], handle_of(b), moving_[b], cell);
    }
    /// Handle of a moving proxy.
    [[nodiscard]] Handle handle_of(Handle moving) const {
        return static_cast<Handle>(still_.size()) + moving;
    }

    std::vector<Proxy> still_;
    std::span<const Proxy> moving_;
    std::uint64_t tests_ = 0;

  private:
    void test(Handle a, const Proxy& of_a, Handle b, const Proxy& of_b, std::uint32_t cell) {
        if (!may_meet(of_a, of_b)) return;
        ++tests_;
        const bool overlaps = overlap(of_a.box, of_b.box);
        const Pair pair{std::min(a, b), std::max(a, b)};
        if (overlaps) pairs_->push_back(pair);
        if (log_ != nullptr) log_->push_back({pair, overlaps, b, cell});
    }

    std::vector<Pair>* pairs_ = nullptr;
    std::vector<PairTest>* log_ = nullptr;
};

struct BroadPhaseOptions {
    Box world;                  ///< m, contains most of the moving boxes
    int quadtree_levels = 4;    ///< 1…8
    int adaptive_capacity = 8;  ///< proxies in a node
    int adaptive_depth = 8;     ///< splits
    double grid_cell = 0;       ///< m, 0: fitted to the boxes
};

/// Tests every pair: n(n−1)/2 for n balls. All other broad phases are tested against it.
[[nodiscard]] std::unique_ptr<BroadPhase> make_brute_force(std::vector<Proxy> still,
                                                           const BroadPhaseOptions& options);

/// The full quadtree in an array, with quadtree_levels below the root. Boxes outside `world` belong to the
/// cells at the border.
[[nodiscard]] std::unique_ptr<BroadPhase> make_quadtree(std::vector<Proxy> still,
                                                        const BroadPhaseOptions& options);

/// A quadtree that splits a node of more than adaptive_capacity proxies, at most adaptive_depth times. A box
/// that crosses a split stays in the node above it.
[[nodiscard]] std::unique_ptr<BroadPhase> make_adaptive_quadtree(std::vector<Proxy> still,
                                                                 const BroadPhaseOptions& options);

/// A uniform grid of square cells, grid_cell wide; 0 fits the cells to the moving boxes. Boxes outside
/// `world` belong to the cells at the border. At most 2^22 cells, and 1,024 for each moving box if they are
/// fitted: too small a cell is enlarged.
[[nodiscard]] std::unique_ptr<BroadPhase> make_grid(std::vector<Proxy> still,
                                                    const BroadPhaseOptions& options);

/// Sweep and prune along x.
[[nodiscard]] std::unique_ptr<BroadPhase> make_sweep(std::vector<Proxy> still,
                                                     const BroadPhaseOptions& options);

}  // namespace flipside::custom

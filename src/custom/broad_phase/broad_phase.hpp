#pragma once
/// Broad phase: which pairs of boxes overlap. It knows boxes and handles, no shapes.

#include <algorithm>
#include <compare>
#include <memory>
#include <span>
#include <vector>

#include "custom/geometry/bounds.hpp"
#include "world/inspector.hpp"
#include "world/statistics.hpp"

namespace flipside::custom {

/// A proxy's place: first the still ones as given to the constructor, then the moving ones as given to
/// find_pairs().
using Handle = std::uint32_t;

/// What the broad phase sees of a thing.
struct Proxy {
    Box box;
    std::uint32_t layer = 1;            ///< one bit
    std::uint32_t collides_with = ~0U;  ///< mask of layers
    bool ball = false;                  ///< a ball, or else part of the table
    bool active = false;                ///< awake, or moving; two inactive things cannot start to touch
};

/// Whether two proxies are worth a test of their boxes: one is active, one is a ball, and layers meet.
[[nodiscard]] constexpr bool may_meet(const auto& a, const auto& b) {
    return (a.active || b.active) && (a.ball || b.ball) && layers_meet(a, b);
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
    Handle seeker = 0;             ///< whose search it belongs to
    std::uint32_t cell = no_cell;  ///< of a tree, where the other one was listed
};

/// A node of a tree, or a cell of a grid.
struct Cell {
    Box box;
    int listed = 0;                  ///< proxies that are listed in it, not below it
    std::uint32_t index = no_cell;   ///< in the tree's array; none in a grid
    std::uint32_t parent = no_cell;  ///< none of the root
    int level = 0;                   ///< of the root: 0
    bool still = false;              ///< of a tree that has only still proxies
};

/// Nodes of trees, by index, that the search for one proxy's neighbours goes to.
struct Visited {
    std::vector<std::uint32_t> cells, still_cells;
};

class BroadPhase {
  public:
    virtual ~BroadPhase() = default;

    /// Replaces `pairs` by every overlapping pair that may meet, each once, in order. Pairs of still
    /// proxies are never looked at. Allocates only while it meets larger inputs than ever before.
    virtual void find_pairs(std::span<const Proxy> moving, std::vector<Pair>& pairs) = 0;
    /// Tests of one box against another since the start, those that insertion cost included.
    [[nodiscard]] std::uint64_t tests() const { return tests_; }
    [[nodiscard]] virtual BroadPhaseFacts facts() const = 0;
    /// From now on every such test of two proxies is added to `log`; null: none is.
    void log_tests(std::vector<PairTest>* log) { log_ = log; }
    /// Draws the cells as of the last find_pairs().
    virtual void inspect(Inspector& inspector) const = 0;
    /// For traces: nodes of trees that list something at or below them, as of the last find_pairs(), parents
    /// first. Empty where there is no tree.
    [[nodiscard]] virtual std::vector<Cell> tree() const { return {}; }
    /// For traces: the same of the search of a moving proxy, by its handle. Cost: linear in the tree.
    [[nodiscard]] virtual Visited visited(Handle) const { return {}; }

  protected:
    /// Tests the boxes of two that may meet, and lists them where they overlap. It belongs to the search of
    /// b, which found a in a cell.
    void test(Handle a, const Proxy& of_a, Handle b, const Proxy& of_b, std::vector<Pair>& pairs,
              std::uint32_t cell = no_cell) {
        if (!may_meet(of_a, of_b)) return;
        ++tests_;
        const bool met = overlap(of_a.box, of_b.box);
        const Pair pair{std::min(a, b), std::max(a, b)};
        if (met) pairs.push_back(pair);
        if (log_ != nullptr) log_->push_back({pair, met, b, cell});
    }

    std::uint64_t tests_ = 0;

  private:
    std::vector<PairTest>* log_ = nullptr;
};

/// Every pair is tested: n(n−1)/2 for n balls. The twin that every other broad phase is checked against.
[[nodiscard]] std::unique_ptr<BroadPhase> make_brute_force(std::vector<Proxy> still);

/// The full quadtree in an array, `levels` (1…8) below the root, over `world`; what is outside counts to the
/// cells at the border.
[[nodiscard]] std::unique_ptr<BroadPhase> make_quadtree(std::vector<Proxy> still, const Box& world,
                                                        int levels);

/// A quadtree that splits a node of more than `capacity` proxies, `depth` times at most; what straddles a
/// split stays above it.
[[nodiscard]] std::unique_ptr<BroadPhase> make_adaptive_quadtree(std::vector<Proxy> still, const Box& world,
                                                                 int capacity, int depth);

/// Uniform grid over `world` of square cells, `cell` m wide; 0 fits the cell to the moving boxes as they
/// come. What is outside counts to the cells at the border. At most 2^22 cells: too small a cell is enlarged.
[[nodiscard]] std::unique_ptr<BroadPhase> make_grid(std::vector<Proxy> still, const Box& world, double cell);

/// Sweep and prune along x.
[[nodiscard]] std::unique_ptr<BroadPhase> make_sweep(std::vector<Proxy> still);

}  // namespace flipside::custom

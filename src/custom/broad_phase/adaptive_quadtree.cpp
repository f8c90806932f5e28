// Adaptive quadtree: a node with more than adaptive_capacity proxies is split at its centre, at most
// adaptive_depth times, so cells are small where proxies are dense. A proxy that crosses a split stays in the
// node that is split. So every proxy is listed once, and proxies that overlap it are in its node, below it or
// above it.
//
// The tree of the still proxies is built once; the tree of the moving ones is built for every search by
// partition: the proxies of a node lie together, its own first and then child by child. The query of a moving
// proxy visits the proxies after it in its node, those below that its box reaches, and the whole still tree.
//
// Comparing a proxy with the centre of a node counts as one box test, in building and in queries.
// Cost: O(n·depth + pairs in the same cells); a proxy that crosses an upper split is tested in many nodes.
// Finkel, Bentley 1974, "Quad trees"; proxies in the smallest node that contains them: Samet 1990, "The
// Design and Analysis of Spatial Data Structures", 3.4 (the MX-CIF tree, after Kedem 1982).

#include <algorithm>

#include "custom/broad_phase/broad_phase.hpp"

namespace flipside::custom {

namespace {

class Tree {
  public:
    explicit Tree(const BroadPhaseOptions& options)
        : world_(options.world),
          capacity_(static_cast<std::uint32_t>(options.adaptive_capacity)),
          depth_(options.adaptive_depth) {
        nodes_.push_back({});
    }

    /// Returns the number of box tests.
    std::uint64_t build(std::span<const Proxy> proxies) {
        const auto count = static_cast<std::uint32_t>(proxies.size());
        // At each depth at most count / (capacity + 1) nodes are split.
        nodes_.reserve(1 + 4 * static_cast<std::size_t>(depth_) * (count / (capacity_ + 1)));
        proxies_ = proxies;
        items_.resize(count);
        for (Handle i = 0; i < count; ++i) items_[i] = i;
        sorted_.resize(count);
        nodes_.assign(1, {middle_of(world_), 0, count, count, 0});
        levels_ = 0;
        tests_ = 0;
        split(0, 0.25 * (world_.max - world_.min), 1);
        return tests_;
    }

    /// Visits the items in a node, and in the nodes below it that a box reaches, each with its node. Returns
    /// the number of box tests.
    std::uint64_t reach(const Box& box, auto&& visit, std::uint32_t node = 0) const {
        const Node& n = nodes_[node];
        for (std::uint32_t i = n.begin; i < n.own_end; ++i) visit(items_[i], node);
        return n.children != 0 ? reach_below(box, visit, node) : 0;
    }
    std::uint64_t reach_below(const Box& box, auto&& visit, std::uint32_t node) const {
        const Node& n = nodes_[node];
        std::uint64_t tests = 1;
        for (std::uint32_t child = 0; child < 4; ++child)
            if (reaches(box, n, child)) tests += reach(box, visit, n.children + child);
        return tests;
    }

    /// Visits all nodes with their index, their own items, and whether they have children.
    void each_node(auto&& visit) const {
        for (std::uint32_t i = 0; i < nodes_.size(); ++i) {
            const Node& n = nodes_[i];
            visit(i, std::span(items_).subspan(n.begin, n.own_end - n.begin), n.children != 0);
        }
    }
    /// Visits the cells of all nodes, parents first, each with whether it is a leaf. `still`: of the cells.
    void each_cell(bool still, auto&& visit) const { each_cell({world_, 0, 0, no_cell, 0, still}, visit); }
    /// Adds the nodes that a box reaches, from `node` down.
    void add_reached(const Box& box, std::uint32_t node, std::vector<std::uint32_t>& reached) const {
        reached.push_back(node);
        const Node& n = nodes_[node];
        if (n.children == 0) return;
        for (std::uint32_t child = 0; child < 4; ++child)
            if (reaches(box, n, child)) add_reached(box, n.children + child, reached);
    }

    [[nodiscard]] const Box& box_of(Handle item) const { return proxies_[item].box; }
    [[nodiscard]] int levels() const { return levels_; }
    [[nodiscard]] int nodes() const { return static_cast<int>(nodes_.size()); }

  private:
    struct Node {
        Vec2 middle;
        /// Indices into items_: its own from begin to own_end, then those of the children.
        std::uint32_t begin = 0, own_end = 0, end = 0;
        std::uint32_t children = 0;  ///< index of the first of four; 0 without children
    };
    static constexpr int straddles = -1;

    /// Whether a box reaches a child that is not empty.
    [[nodiscard]] bool reaches(const Box& box, const Node& n, std::uint32_t child) const {
        const bool to_side = child % 2 == 0 ? box.min.x < n.middle.x : box.max.x >= n.middle.x;
        const bool to_height = child < 2 ? box.min.y < n.middle.y : box.max.y >= n.middle.y;
        return to_side && to_height && nodes_[n.children + child].begin < nodes_[n.children + child].end;
    }
    static Box part_of(const Box& box, Vec2 middle, std::uint32_t child) {
        Box part = box;
        (child % 2 == 0 ? part.max.x : part.min.x) = middle.x;
        (child < 2 ? part.max.y : part.min.y) = middle.y;
        return part;
    }
    void each_cell(Cell cell, auto& visit) const {
        const Node& n = nodes_[cell.index];
        cell.listed = static_cast<int>(n.own_end - n.begin);
        visit(cell, n.children == 0);
        if (n.children == 0) return;
        for (std::uint32_t i = 0; i < 4; ++i)
            each_cell(
                {part_of(cell.box, n.middle, i), 0, n.children + i, cell.index, cell.level + 1, cell.still},
                visit);
    }

    static Vec2 middle_of(const Box& box) { return 0.5 * (box.min + box.max); }

    /// The child that contains a box: below left, below right, above left, above right.
    int child_for(Vec2 middle, const Box& box) {
        ++tests_;
        const bool left = box.max.x < middle.x, right = box.min.x >= middle.x;
        const bool below = box.max.y < middle.y, above = box.min.y >= middle.y;
        if (!(left || right) || !(below || above)) return straddles;
        return (above ? 2 : 0) + (right ? 1 : 0);
    }

    /// `quarter`: a quarter of the size of the node, the offset from its centre to those of its children.
    void split(std::uint32_t node, Vec2 quarter, int level) {
        const Node n = nodes_[node];
        if (n.end - n.begin <= capacity_ || level > depth_) return;
        std::uint32_t counts[5] = {};
        for (std::uint32_t i = n.begin; i < n.end; ++i) {
            sorted_[i] = {items_[i], child_for(n.middle, proxies_[items_[i]].box)};
            ++counts[sorted_[i].child + 1];
        }
        if (counts[0] == n.end - n.begin) return;
        std::uint32_t at[5] = {n.begin};
        for (int i = 1; i < 5; ++i) at[i] = at[i - 1] + counts[i - 1];
        const auto first = static_cast<std::uint32_t>(nodes_.size());
        nodes_[node].own_end = at[1];
        nodes_[node].children = first;
        for (int i = 0; i < 4; ++i) {
            const Vec2 offset = {i % 2 == 0 ? -quarter.x : quarter.x, i < 2 ? -quarter.y : quarter.y};
            const std::uint32_t end = at[i + 1] + counts[i + 1];
            nodes_.push_back({n.middle + offset, at[i + 1], end, end, 0});
        }
        for (std::uint32_t i = n.begin; i < n.end; ++i) items_[at[sorted_[i].child + 1]++] = sorted_[i].item;
        levels_ = std::max(levels_, level);
        for (std::uint32_t child = first; child < first + 4; ++child) split(child, 0.5 * quarter, level + 1);
    }

    struct Sorted {
        Handle item;
        int child;
    };
    Box world_;
    std::uint32_t capacity_;
    int depth_, levels_ = 0;
    std::span<const Proxy> proxies_;
    std::vector<Node> nodes_;
    std::vector<Handle> items_;
    std::vector<Sorted> sorted_;  ///< buffer of split()
    std::uint64_t tests_ = 0;
};

class AdaptiveQuadtree final : public BroadPhase {
  public:
    AdaptiveQuadtree(std::vector<Proxy> still, const BroadPhaseOptions& options)
        : BroadPhase(std::move(still)), still_tree_(options), moving_tree_(options) {
        still_tree_.build(still_);
    }

    [[nodiscard]] BroadPhaseFacts facts() const override {
        BroadPhaseFacts facts{
            .name = "adaptive quadtree", .levels = moving_tree_.levels(), .nodes = moving_tree_.nodes()};
        moving_tree_.each_node([&](std::uint32_t, std::span<const Handle> items, bool split) {
            if (!split) ++facts.leaves;
            facts.most_in_leaf = std::max(facts.most_in_leaf, static_cast<int>(items.size()));
        });
        return facts;
    }

    void inspect(Inspector& inspector) const override {
        moving_tree_.each_cell(false, [&](const Cell& cell, bool leaf) {
            if (leaf) inspector.cell(cell.box, cell.listed);
        });
    }

    [[nodiscard]] std::vector<Cell> tree() const override {
        std::vector<Cell> cells;
        const auto add = [&](const Cell& cell, bool leaf) {
            if (!leaf || cell.listed > 0) cells.push_back(cell);
        };
        still_tree_.each_cell(true, add);
        moving_tree_.each_cell(false, add);
        return cells;
    }

    /// The nodes from its own down, and those of the still tree.
    [[nodiscard]] Visited visited(Handle moving) const override {
        Visited visited;
        const auto proxy = moving - static_cast<Handle>(still_.size());
        moving_tree_.each_node([&](std::uint32_t node, std::span<const Handle> items, bool) {
            const auto at = std::ranges::find(items, proxy);
            if (at == items.end()) return;
            const Box& box = moving_tree_.box_of(proxy);
            moving_tree_.add_reached(box, node, visited.cells);
            still_tree_.add_reached(box, 0, visited.still_cells);
        });
        return visited;
    }

  private:
    void search() override {
        tests_ += moving_tree_.build(moving_);
        moving_tree_.each_node([&](std::uint32_t node, std::span<const Handle> items, bool split) {
            for (std::size_t i = 0; i < items.size(); ++i) {
                const Handle b = items[i];
                const Box& box = moving_[b].box;
                const auto test = [&](Handle a, std::uint32_t cell) { test_moving(a, b, cell); };
                for (const Handle a : items.subspan(i + 1)) test(a, node);
                if (split) tests_ += moving_tree_.reach_below(box, test, node);
                tests_ +=
                    still_tree_.reach(box, [&](Handle a, std::uint32_t cell) { test_still(a, b, cell); });
            }
        });
    }

    Tree still_tree_, moving_tree_;
};

}  // namespace

std::unique_ptr<BroadPhase> make_adaptive_quadtree(std::vector<Proxy> still,
                                                   const BroadPhaseOptions& options) {
    return std::make_unique<AdaptiveQuadtree>(std::move(still), options);
}

}  // namespace flipside::custom

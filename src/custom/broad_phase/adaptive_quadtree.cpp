// Adaptive quadtree: a node with more than adaptive_capacity proxies is split at its centre, at most
// adaptive_depth times, so cells are small where proxies are dense. A proxy that crosses a split stays in the
// node that is split. So every proxy is listed once, and proxies that overlap it are in its node, below it or
// above it.
//
// The tree of the still proxies is built once; the tree of the moving ones is built for every search by
// partition: the proxies of a node lie together, its own first and then child by child. The query of a moving
// proxy visits the proxies after it in its node, those below that its box reaches, and those of the still
// tree.
//
// Comparing a proxy with the centre of a node counts as one box test, in building and in queries.
// Cost: O(n·depth + pairs in the same cells); a proxy that crosses an upper split is tested in many nodes.
// Finkel, Bentley 1974, "Quad trees"; proxies in the smallest node that contains them: Samet 1990, "The
// Design and Analysis of Spatial Data Structures", 3.4 (the MX-CIF tree, after Kedem 1982).

#include <numeric>

#include "custom/broad_phase/broad_phase.hpp"

namespace flipside::custom {

namespace {

class Tree {
  public:
    struct Node : Cell {
        std::uint32_t begin = 0;     ///< index into items_ of its own items; those of its children follow
        std::uint32_t children = 0;  ///< index of the first of four, if it is no leaf
    };

    /// Keeps a reference to the proxies and counts its tests in `tests`. `still`: what the proxies are.
    Tree(const std::vector<Proxy>& proxies, std::uint64_t& tests, const BroadPhaseOptions& options,
         bool still)
        : proxies_(proxies), tests_(tests), options_(options), still_(still) {}

    /// Builds the tree of the proxies from handle `first` on.
    void build(Handle first) {
        const std::size_t count = proxies_.size() - first;
        const auto depth = static_cast<std::size_t>(options_.adaptive_depth),
                   capacity = static_cast<std::size_t>(options_.adaptive_capacity);
        // At each depth at most count / (capacity + 1) nodes are split.
        nodes_.reserve(1 + 4 * depth * (count / (capacity + 1)));
        items_.resize(count);
        sorted_.resize(count);
        std::iota(items_.begin(), items_.end(), first);
        const auto all = static_cast<int>(count);
        nodes_.assign(1, {{options_.world, all, all, 0, no_cell, 0, true, still_}});
        split(0);
    }

    /// Visits a node, and those below it that a box reaches unless they are empty, each with its own items.
    void reach(const Box& box, std::uint32_t node, auto&& visit) const {
        visit(node, items(node));
        const Node& n = nodes_[node];
        if (n.leaf) return;
        ++tests_;
        const Vec2 middle = middle_of(n.box);
        const bool columns[] = {box.min.x < middle.x, box.max.x >= middle.x};
        const bool rows[] = {box.min.y < middle.y, box.max.y >= middle.y};
        for (std::uint32_t i = 0; i < 4; ++i) {
            const bool empty = nodes_[n.children + i].within == 0;
            if (columns[i % 2] && rows[i / 2] && !empty) reach(box, n.children + i, visit);
        }
    }

    /// Parents come first.
    [[nodiscard]] const std::vector<Node>& nodes() const { return nodes_; }
    /// The proxies in a node, without those below it.
    [[nodiscard]] std::span<const Handle> items(std::uint32_t node) const {
        return std::span(items_).subspan(nodes_[node].begin, static_cast<std::size_t>(nodes_[node].listed));
    }

  private:
    /// 0 for a box that crosses the middle, else 1 + the number of the child that contains it.
    static std::uint32_t group_of(const Box& box, Vec2 middle) {
        const bool left = box.max.x < middle.x, right = box.min.x >= middle.x;
        const bool below = box.max.y < middle.y, above = box.min.y >= middle.y;
        return (left || right) && (below || above) ? 1U + (above ? 2U : 0U) + (right ? 1U : 0U) : 0U;
    }

    void split(std::uint32_t node) {
        const Node n = nodes_[node];
        const std::uint32_t within = static_cast<std::uint32_t>(n.within), end = n.begin + within;
        if (n.within <= options_.adaptive_capacity || n.level == options_.adaptive_depth) return;
        tests_ += within;
        const Vec2 middle = middle_of(n.box);
        std::uint32_t begins[6] = {n.begin};  // of the groups, and the end of the last
        for (std::uint32_t i = n.begin; i < end; ++i) {
            sorted_[i] = {items_[i], group_of(proxies_[items_[i]].box, middle)};
            ++begins[sorted_[i].group + 1];
        }
        std::partial_sum(std::begin(begins), std::end(begins), std::begin(begins));
        if (begins[1] == end) return;
        const auto first = static_cast<std::uint32_t>(nodes_.size());
        nodes_[node].listed = static_cast<int>(begins[1] - n.begin);
        nodes_[node].leaf = false;
        nodes_[node].children = first;
        for (std::uint32_t i = 0; i < 4; ++i) {
            const auto count = static_cast<int>(begins[i + 2] - begins[i + 1]);
            nodes_.push_back(
                {{quarter_of(n.box, i), count, count, first + i, node, n.level + 1, true, still_},
                 begins[i + 1]});
        }
        for (std::uint32_t i = n.begin; i < end; ++i) items_[begins[sorted_[i].group]++] = sorted_[i].item;
        for (std::uint32_t child = first; child < first + 4; ++child) split(child);
    }

    struct Sorted {
        Handle item;
        std::uint32_t group;
    };
    const std::vector<Proxy>& proxies_;
    std::uint64_t& tests_;
    BroadPhaseOptions options_;
    bool still_;
    std::vector<Node> nodes_;
    std::vector<Handle> items_;
    std::vector<Sorted> sorted_;  ///< buffer of split()
};

class AdaptiveQuadtree final : public BroadPhase {
  public:
    AdaptiveQuadtree(std::vector<Proxy> still, const BroadPhaseOptions& options)
        : BroadPhase(std::move(still)),
          still_tree_(proxies_, tests_, options, true),
          moving_tree_(proxies_, tests_, options, false) {
        still_tree_.build(0);
        moving_tree_.build(first_moving_);
        tests_ = 0;
    }

    [[nodiscard]] BroadPhaseFacts facts() const override {
        BroadPhaseFacts facts{.name = "adaptive quadtree",
                              .nodes = static_cast<int>(moving_tree_.nodes().size())};
        for (const Tree::Node& node : moving_tree_.nodes()) {
            facts.levels = std::max(facts.levels, node.level);
            facts.leaves += node.leaf;
            facts.most_in_leaf = std::max(facts.most_in_leaf, node.listed);
        }
        return facts;
    }

    [[nodiscard]] std::vector<Cell> cells() const override {
        std::vector<Cell> cells(still_tree_.nodes().begin(), still_tree_.nodes().end());
        cells.insert(cells.end(), moving_tree_.nodes().begin(), moving_tree_.nodes().end());
        return cells;
    }

  private:
    void search() override {
        moving_tree_.build(first_moving_);
        for (std::uint32_t node = 0; node < moving_tree_.nodes().size(); ++node) {
            const std::span<const Handle> own = moving_tree_.items(node);
            for (std::size_t i = 0; i < own.size(); ++i) {
                const Handle b = own[i];
                const auto test_with = [&](std::span<const Handle> items, std::uint32_t cell, bool still) {
                    log_visit(b, cell, still);
                    for (const Handle a : items) test(a, b, cell);
                };
                moving_tree_.reach(proxies_[b].box, node, [&](std::uint32_t cell, auto items) {
                    test_with(cell == node ? own.subspan(i + 1) : items, cell, false);
                });
                still_tree_.reach(proxies_[b].box, 0,
                                  [&](std::uint32_t cell, auto items) { test_with(items, cell, true); });
            }
        }
    }

    Tree still_tree_, moving_tree_;
};

}  // namespace

std::unique_ptr<BroadPhase> make_adaptive_quadtree(std::vector<Proxy> still,
                                                   const BroadPhaseOptions& options) {
    return std::make_unique<AdaptiveQuadtree>(std::move(still), options);
}

}  // namespace flipside::custom

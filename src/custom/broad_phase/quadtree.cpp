// The full quadtree in an array: node i has its children at 4i+1 … 4i+4 (top left, top right, bottom left,
// bottom right). So d levels below the root make (4^(d+1)−1)/3 nodes and 4^d leaves, all of one size. A proxy
// is listed in every leaf that its box overlaps. Still proxies are listed once; moving ones are listed again
// for every search. Pairs are searched leaf by leaf (cell_lists.hpp), only in leaves that list a moving
// proxy.
//
// Since all leaves have one size, the leaves under a box follow from its four coordinates without a walk down
// the tree; this counts as one box test. Cost: O(n·leaves per box + pairs sharing a leaf). Finkel, Bentley
// 1974, "Quad trees"; the array form after Samet 1984.

#include <algorithm>

#include "custom/broad_phase/capacity.hpp"
#include "custom/broad_phase/cell_lists.hpp"

namespace flipside::custom {

namespace {

using Node = std::uint32_t;

class Quadtree final : public CellBroadPhase {
  public:
    Quadtree(std::vector<Proxy> still, const BroadPhaseOptions& options)
        : CellBroadPhase(std::move(still)),
          world_(options.world),
          levels_(options.quadtree_levels),
          side_(1U << levels_),
          leaf_size_((world_.max - world_.min) / static_cast<double>(side_)),
          first_leaf_(((1U << (2 * levels_)) - 1) / 3),
          occupied_(first_leaf_ + side_ * side_) {
        still_lists_.reset(side_ * side_);
        moving_lists_.reset(side_ * side_);
        // Lists grow at their front: from the last proxy on, so that they are in rising order.
        still_cells_.resize(still_.size());
        for (auto i = static_cast<Handle>(still_.size()); i-- > 0;) {
            still_cells_[i] = leaves_under(still_[i].box);
            each_leaf(still_cells_[i], [&](Node leaf) { still_lists_.add(leaf, i); });
        }
        for (Node leaf = 0; leaf < side_ * side_; ++leaf)
            most_still_in_leaf_ = std::max(most_still_in_leaf_, count(leaf));
        most_in_cell_ = most_still_in_leaf_;
    }

    [[nodiscard]] BroadPhaseFacts facts() const override {
        return {.name = "quadtree",
                .levels = levels_,
                .nodes = static_cast<int>(occupied_.size()),
                .leaves = static_cast<int>(side_ * side_),
                .leaf_width = leaf_size_.x,
                .leaf_height = leaf_size_.y,
                .most_in_leaf = most_in_cell_};
    }

    void inspect(Inspector& inspector) const override {
        for (std::uint32_t row = 0; row < side_; ++row)
            for (std::uint32_t column = 0; column < side_; ++column) {
                const Vec2 top_left = {world_.min.x + column * leaf_size_.x,
                                       world_.max.y - row * leaf_size_.y};
                inspector.cell(
                    {{top_left.x, top_left.y - leaf_size_.y}, {top_left.x + leaf_size_.x, top_left.y}},
                    count(leaf_at(column, row)));
            }
    }

    [[nodiscard]] std::vector<Cell> tree() const override {
        std::vector<Cell> cells;
        add_cell(cells, 0, no_cell, 0, world_);
        return cells;
    }

    /// The leaves under the box of the proxy.
    [[nodiscard]] Visited visited(Handle moving) const override {
        Visited visited;
        const auto proxy = static_cast<std::size_t>(moving) - still_.size();
        if (proxy >= moving_cells_.size()) return visited;
        each_leaf(moving_cells_[proxy], [&](Node leaf) { visited.cells.push_back(first_leaf_ + leaf); });
        return visited;
    }

  private:
    void search() override {
        clear(0);
        moving_lists_.links.clear();
        moving_cells_.clear();
        reserve_for(moving_lists_.links, moving_.size(), pairs_per_ball);
        reserve_for(moving_cells_, moving_.size());
        for (Handle i = 0; i < moving_.size(); ++i) insert(i);
        most_in_cell_ = most_still_in_leaf_;
        search_below(0, 0, 0);
    }

    /// Columns from the left, rows from the top.
    [[nodiscard]] CellRange leaves_under(const Box& box) const {
        return {cell_index(box.min.x - world_.min.x, leaf_size_.x, side_),
                cell_index(world_.max.y - box.max.y, leaf_size_.y, side_),
                cell_index(box.max.x - world_.min.x, leaf_size_.x, side_),
                cell_index(world_.max.y - box.min.y, leaf_size_.y, side_)};
    }
    /// Number of a leaf (Morton order): from the root down, two bits per level choose the child.
    [[nodiscard]] Node leaf_at(std::uint32_t column, std::uint32_t row) const {
        Node leaf = 0;
        for (int level = levels_ - 1; level >= 0; --level)
            leaf = 4 * leaf + 2 * ((row >> level) & 1U) + ((column >> level) & 1U);
        return leaf;
    }
    void each_leaf(const CellRange& leaves, auto&& visit) const {
        leaves.each([&](std::uint32_t column, std::uint32_t row) { visit(leaf_at(column, row)); });
    }

    void clear(Node node) {
        if (!occupied_[node]) return;
        occupied_[node] = false;
        if (node >= first_leaf_)
            moving_lists_.first[node - first_leaf_] = CellLists::none;
        else
            for (Node child = 4 * node + 1; child <= 4 * node + 4; ++child) clear(child);
    }

    void insert(Handle proxy) {
        moving_cells_.push_back(leaves_under(moving_[proxy].box));
        ++tests_;
        each_leaf(moving_cells_.back(), [&](Node leaf) {
            moving_lists_.add(leaf, proxy);
            Node node = first_leaf_ + leaf;
            for (; !occupied_[node]; node = (node - 1) / 4) {
                occupied_[node] = true;
                if (node == 0) break;
            }
        });
    }

    /// `column` and `row` of the node among those of its level.
    void search_below(Node node, std::uint32_t column, std::uint32_t row) {
        if (!occupied_[node]) return;
        if (node >= first_leaf_) return search_cell(node - first_leaf_, column, row, node);
        for (Node child = 0; child < 4; ++child)
            search_below(4 * node + 1 + child, 2 * column + child % 2, 2 * row + child / 2);
    }

    /// Adds a node and those below it, if they list any proxy. Returns whether they do.
    bool add_cell(std::vector<Cell>& cells, Node node, Node parent, int level, const Box& box) const {
        const std::size_t at = cells.size();
        const bool leaf = node >= first_leaf_;
        const int listed = leaf ? count(node - first_leaf_) : 0;
        cells.push_back({box, listed, node, parent, level});
        bool any = listed > 0;
        for (Node child = 0; !leaf && child < 4; ++child) {
            const Vec2 middle = 0.5 * (box.min + box.max);
            Box part = box;
            (child % 2 == 0 ? part.max.x : part.min.x) = middle.x;
            (child < 2 ? part.min.y : part.max.y) = middle.y;
            any |= add_cell(cells, 4 * node + 1 + child, node, level + 1, part);
        }
        if (!any) cells.resize(at);
        return any;
    }

    Box world_;
    int levels_;
    std::uint32_t side_;  ///< leaves along one side
    Vec2 leaf_size_;
    Node first_leaf_;
    std::vector<char> occupied_;  ///< per node: whether it or a node below it lists a moving proxy
    int most_still_in_leaf_ = 0;
};

}  // namespace

std::unique_ptr<BroadPhase> make_quadtree(std::vector<Proxy> still, const BroadPhaseOptions& options) {
    return std::make_unique<Quadtree>(std::move(still), options);
}

}  // namespace flipside::custom

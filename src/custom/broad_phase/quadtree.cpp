// The full quadtree in an array: node i has its children at 4i+1 … 4i+4 (below left, below right, above left,
// above right). So d levels below the root make (4^(d+1)−1)/3 nodes and 4^d leaves, all of one size. A proxy
// is listed in the leaves under it (quadtree.hpp), to which a search goes from the root down.
//
// Cost: O(n·levels·leaves per box + pairs sharing a leaf). Finkel, Bentley 1974, "Quad trees"; the array form
// after Samet 1984.

#include "custom/broad_phase/quadtree.hpp"

namespace flipside::custom {

namespace {

using Node = std::uint32_t;

class Quadtree final : public CellBroadPhase {
  public:
    Quadtree(std::vector<Proxy> still, const BroadPhaseOptions& options)
        : CellBroadPhase(std::move(still), options.world),
          levels_(options.quadtree_levels),
          first_leaf_(((1U << (2 * levels_)) - 1) / 3) {
        const std::uint32_t side = 1U << levels_;
        set_cells((world_.max - world_.min) / static_cast<double>(side), side, side);
    }

    [[nodiscard]] BroadPhaseFacts facts() const override {
        const int leaves = 1 << (2 * levels_);
        return {.name = "quadtree",
                .levels = levels_,
                .nodes = static_cast<int>(first_leaf_) + leaves,
                .leaves = leaves,
                .leaf_width = size_.x,
                .leaf_height = size_.y,
                .most_in_leaf = most_in_cell_};
    }

    [[nodiscard]] std::vector<Cell> cells() const override {
        std::vector<Cell> cells;
        add_cells(cells, {world_, 0, 0, 0});
        return cells;
    }

  private:
    void insert(Handle b, const CellRange& range) override {
        each_leaf(range, [&](Node leaf, std::uint32_t column, std::uint32_t row) {
            log_visit(b, leaf);
            list(b, leaf - first_leaf_, column, row, leaf);
        });
    }

    /// Visits the leaves in a range, from the node on this level in this column and row down.
    void each_leaf(const CellRange& range, auto&& visit, Node node = 0, int level = 0,
                   std::uint32_t column = 0, std::uint32_t row = 0) const {
        if (level == levels_) return visit(node, column, row);
        const int shift = levels_ - level - 1;  // 2^shift leaves along the side of a child
        const CellRange children{
            std::max(range.left >> shift, 2 * column), std::max(range.low >> shift, 2 * row),
            std::min(range.right >> shift, 2 * column + 1), std::min(range.high >> shift, 2 * row + 1)};
        children.each([&](std::uint32_t x, std::uint32_t y) {
            each_leaf(range, visit, 4 * node + 1 + 2 * (y % 2) + x % 2, level + 1, x, y);
        });
    }

    /// Adds a cell and those below it. Returns how many proxies they list.
    int add_cells(std::vector<Cell>& cells, Cell cell) const {
        cell.leaf = cell.level == levels_;
        if (cell.leaf) cell.listed = cell.within = count(cell.index - first_leaf_);
        const std::size_t at = cells.size();
        cells.push_back(cell);
        for (Node child = 0; !cell.leaf && child < 4; ++child)
            cell.within += add_cells(cells, {quarter_of(cell.box, child), 0, 0, 4 * cell.index + 1 + child,
                                             cell.index, cell.level + 1});
        return cells[at].within = cell.within;
    }

    int levels_;
    Node first_leaf_;
};

}  // namespace

std::unique_ptr<BroadPhase> make_quadtree(std::vector<Proxy> still, const BroadPhaseOptions& options) {
    return std::make_unique<Quadtree>(std::move(still), options);
}

}  // namespace flipside::custom

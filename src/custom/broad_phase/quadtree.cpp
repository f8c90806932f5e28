// The full quadtree in an array: node i has its children at 4i+1 … 4i+4 (top left, top right, bottom left,
// bottom right), so d levels below the root make (4^(d+1)−1)/3 nodes and 4^d leaves, all of one size.
// A proxy is listed in every leaf that its box overlaps. Still proxies are listed once, when the tree is
// made; moving ones are cleared and listed again for every search. Pairs are sought leaf by leaf, and
// a pair that shares several leaves is looked at only in the first of them.
//
// Because all leaves are of one size, the leaves under a box follow from its corners without walking
// down the tree. That takes the four coordinates once, as one box test does, and is counted as one.
// Cost: O(n·leaves per box + pairs sharing a leaf).
// Finkel, Bentley 1974, "Quad trees"; the array form after Samet 1984.

#include <algorithm>

#include "custom/broad_phase/broad_phase.hpp"
#include "custom/broad_phase/capacity.hpp"

namespace flipside::custom {

namespace {

using Node = std::uint32_t;

/// Leaves under a box: columns from the left, rows from the top, both ends included.
struct Leaves {
    std::uint16_t left, top, right, bottom;
};

class Quadtree final : public BroadPhase {
  public:
    Quadtree(std::vector<Proxy> still, const Box& world, int levels)
        : still_(std::move(still)),
          world_(world),
          levels_(levels),
          side_(1U << levels),
          leaf_size_((world.max - world.min) / static_cast<double>(side_)),
          first_leaf_(((1U << (2 * levels)) - 1) / 3) {
        const std::size_t nodes = first_leaf_ + side_ * side_;
        occupied_.resize(nodes);
        first_moving_.assign(nodes - first_leaf_, nobody);
        list_still();
    }

    void find_pairs(std::span<const Proxy> moving, std::vector<Pair>& pairs) override {
        pairs.clear();
        clear(0);
        listings_.clear();
        reserve_for(listings_, moving.size(), pairs_per_ball);
        reserve_for(moving_leaves_, moving.size());
        moving_leaves_.clear();
        moving_ = moving;
        if (std::ranges::none_of(moving, &Proxy::active)) return;
        for (const Proxy& proxy : moving) insert(proxy);
        most_in_leaf_ = most_still_in_leaf_;
        search(0, pairs);
        std::ranges::sort(pairs);
    }

    [[nodiscard]] BroadPhaseFacts facts() const override {
        return {.name = "quadtree",
                .levels = levels_,
                .nodes = static_cast<int>(occupied_.size()),
                .leaves = static_cast<int>(side_ * side_),
                .leaf_width = leaf_size_.x,
                .leaf_height = leaf_size_.y,
                .most_in_leaf = most_in_leaf_};
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

    /// The leaves under its box.
    [[nodiscard]] Visited visited(Handle moving) const override {
        Visited visited;
        const auto proxy = static_cast<std::size_t>(moving) - still_.size();
        if (proxy >= moving_leaves_.size()) return visited;
        each_leaf(moving_leaves_[proxy], [&](Node leaf) { visited.cells.push_back(first_leaf_ + leaf); });
        return visited;
    }

  private:
    static constexpr std::uint32_t nobody = ~0U;
    /// A link in the list of moving proxies of one leaf.
    struct Listing {
        Handle proxy;  ///< into moving_
        std::uint32_t next;
    };

    [[nodiscard]] std::uint16_t cell(double offset, double size) const {
        // Written so that anything outside, even at infinity, lands in the outermost cell.
        const double last = static_cast<double>(side_ - 1);
        const double at = std::floor(offset / size);
        return static_cast<std::uint16_t>(at > 0 ? std::min(at, last) : 0);
    }
    [[nodiscard]] Leaves leaves_under(const Box& box) const {
        return {cell(box.min.x - world_.min.x, leaf_size_.x), cell(world_.max.y - box.max.y, leaf_size_.y),
                cell(box.max.x - world_.min.x, leaf_size_.x), cell(world_.max.y - box.min.y, leaf_size_.y)};
    }
    /// Number of a leaf among the leaves: from the root down, two bits per level choose the child.
    [[nodiscard]] Node leaf_at(std::uint32_t column, std::uint32_t row) const {
        Node leaf = 0;
        for (int level = levels_ - 1; level >= 0; --level)
            leaf = 4 * leaf + 2 * ((row >> level) & 1U) + ((column >> level) & 1U);
        return leaf;
    }
    void each_leaf(const Leaves& leaves, auto&& visit) const {
        for (std::uint32_t row = leaves.top; row <= leaves.bottom; ++row)
            for (std::uint32_t column = leaves.left; column <= leaves.right; ++column)
                visit(leaf_at(column, row));
    }
    /// The first leaf that two proxies share, as each_leaf() goes.
    [[nodiscard]] Node home(const Leaves& a, const Leaves& b) const {
        return leaf_at(std::max(a.left, b.left), std::max(a.top, b.top));
    }

    void list_still() {
        std::vector<std::vector<Handle>> lists(occupied_.size() - first_leaf_);
        for (Handle i = 0; i < still_.size(); ++i) {
            still_leaves_.push_back(leaves_under(still_[i].box));
            each_leaf(still_leaves_.back(), [&](Node leaf) { lists[leaf].push_back(i); });
        }
        still_begin_.push_back(0);
        for (const auto& list : lists) {
            still_listed_.insert(still_listed_.end(), list.begin(), list.end());
            still_begin_.push_back(static_cast<std::uint32_t>(still_listed_.size()));
            most_still_in_leaf_ = std::max(most_still_in_leaf_, static_cast<int>(list.size()));
        }
        most_in_leaf_ = most_still_in_leaf_;
    }

    void clear(Node node) {
        if (!occupied_[node]) return;
        occupied_[node] = false;
        if (node >= first_leaf_)
            first_moving_[node - first_leaf_] = nobody;
        else
            for (Node child = 4 * node + 1; child <= 4 * node + 4; ++child) clear(child);
    }

    void insert(const Proxy& proxy) {
        const auto handle = static_cast<Handle>(moving_leaves_.size());
        moving_leaves_.push_back(leaves_under(proxy.box));
        ++tests_;
        each_leaf(moving_leaves_.back(), [&](Node leaf) {
            listings_.push_back({handle, first_moving_[leaf]});
            first_moving_[leaf] = static_cast<std::uint32_t>(listings_.size() - 1);
            Node node = first_leaf_ + leaf;
            for (; !occupied_[node]; node = (node - 1) / 4) {
                occupied_[node] = true;
                if (node == 0) break;
            }
        });
    }

    void search(Node node, std::vector<Pair>& pairs) {
        if (!occupied_[node]) return;
        if (node >= first_leaf_) return search_leaf(node - first_leaf_, pairs);
        for (Node child = 4 * node + 1; child <= 4 * node + 4; ++child) search(child, pairs);
    }

    void search_leaf(Node leaf, std::vector<Pair>& pairs) {
        most_in_leaf_ = std::max(most_in_leaf_, count(leaf));
        const auto first = static_cast<Handle>(still_.size());
        for (std::uint32_t i = first_moving_[leaf]; i != nobody; i = listings_[i].next) {
            const Handle b = listings_[i].proxy;
            for (std::uint32_t k = still_begin_[leaf]; k < still_begin_[leaf + 1]; ++k) {
                const Handle a = still_listed_[k];
                if (home(still_leaves_[a], moving_leaves_[b]) == leaf)
                    test(a, still_[a], first + b, moving_[b], pairs, first_leaf_ + leaf);
            }
            // Lists grow at their front, so what follows has a lower handle.
            for (std::uint32_t j = listings_[i].next; j != nobody; j = listings_[j].next) {
                const Handle a = listings_[j].proxy;
                if (home(moving_leaves_[a], moving_leaves_[b]) == leaf)
                    test(first + a, moving_[a], first + b, moving_[b], pairs, first_leaf_ + leaf);
            }
        }
    }

    /// Adds a node and what is below it, if anything is listed there. Returns whether.
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

    /// How many proxies a leaf lists.
    [[nodiscard]] int count(Node leaf) const {
        auto n = static_cast<int>(still_begin_[leaf + 1] - still_begin_[leaf]);
        for (std::uint32_t i = first_moving_[leaf]; i != nobody; i = listings_[i].next) ++n;
        return n;
    }

    std::vector<Proxy> still_;
    Box world_;
    int levels_;
    std::uint32_t side_;  ///< leaves along one side
    Vec2 leaf_size_;
    Node first_leaf_;
    std::vector<char> occupied_;  ///< per node: a moving proxy is listed at or below it

    std::vector<Leaves> still_leaves_;  ///< per still proxy
    std::vector<std::uint32_t>
        still_begin_;  ///< per leaf and one more: where its part of still_listed_ begins
    std::vector<Handle> still_listed_;
    int most_still_in_leaf_ = 0;

    std::span<const Proxy> moving_;
    std::vector<Leaves> moving_leaves_;
    std::vector<std::uint32_t> first_moving_;  ///< per leaf: into listings_, or nobody
    std::vector<Listing> listings_;
    int most_in_leaf_ = 0;
};

}  // namespace

std::unique_ptr<BroadPhase> make_quadtree(std::vector<Proxy> still, const Box& world, int levels) {
    return std::make_unique<Quadtree>(std::move(still), world, levels);
}

}  // namespace flipside::custom

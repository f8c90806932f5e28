// Trees: a cell between its parent and its children, and where a search went.

#include <algorithm>

#include "app/window/constructions.hpp"
#include "world/printable.hpp"

namespace flipside::app {

namespace {

struct TreeView {
    const Construction& drawn;
    bool still;  ///< which of two trees

    [[nodiscard]] bool is_of(const TraceItem& item) const {
        return item.kind == "cell" && item.find("level") != nullptr && item.get<bool>("of_still") == still;
    }
    [[nodiscard]] const TraceItem* find(std::int64_t cell) const {
        const auto at = std::ranges::find_if(drawn.stage.items, [&](const TraceItem& item) {
            return is_of(item) && item.get<std::int64_t>("cell") == cell;
        });
        return at == drawn.stage.items.end() ? nullptr : &*at;
    }
    static std::string level_and_index(const TraceItem& cell) {
        return "level " + std::to_string(cell.get<std::int64_t>("level")) + ", cell " +
               std::to_string(cell.get<std::int64_t>("cell"));
    }
    /// Inside a cell at its top, or above one that is too small for words.
    void note(const TraceItem& cell, const std::string& words, sf::Color color) const {
        const Box& box = cell.get<Box>("box");
        const bool small = drawn.metres(60) > box.max.y - box.min.y;
        drawn.word({0.5 * (box.min.x + box.max.x), box.max.y}, {0, small ? 1.0 : -1.0}, 3, words, color);
    }
    void family(const TraceItem& cell) const {
        const auto index = cell.get<std::int64_t>("cell");
        drawn.frame(cell.get<Box>("box"), 3, colour::lit);
        note(cell,
             level_and_index(cell) + ": " + std::to_string(cell.get<std::int64_t>("listed")) + " listed",
             colour::lit);
        if (const TraceValue* above = cell.find("parent"))
            if (const TraceItem* parent = find(std::get<std::int64_t>(*above))) {
                drawn.frame(parent->get<Box>("box"), 2, colour::text);
                note(*parent, "parent: " + level_and_index(*parent), colour::text);
            }
        for (const TraceItem& child : drawn.stage.items) {
            if (!is_of(child)) continue;
            const TraceValue* parent = child.find("parent");
            if (parent == nullptr || std::get<std::int64_t>(*parent) != index) continue;
            const Box& box = child.get<Box>("box");
            drawn.frame(box, 1.5, colour::cells);
            drawn.word(0.5 * (box.min + box.max), {0, -1}, 0,
                       "child: cell " + std::to_string(child.get<std::int64_t>("cell")), colour::cells);
        }
    }
    /// All get a frame, and those at which the search ended a tint.
    void visited(const std::vector<double>& cells) const {
        for (const double index : cells) {
            const TraceItem* cell = find(static_cast<std::int64_t>(index));
            if (cell == nullptr) continue;
            const Box& box = cell->get<Box>("box");
            drawn.frame(box, still ? 1 : 2, with_alpha(colour::cells, still ? 0.6 : 1));
            const bool ended = std::ranges::none_of(cells, [&](double below) {
                const TraceItem* other = find(static_cast<std::int64_t>(below));
                const TraceValue* parent = other == nullptr ? nullptr : other->find("parent");
                return parent != nullptr &&
                       std::get<std::int64_t>(*parent) == static_cast<std::int64_t>(index);
            });
            const Vec2 corners[] = {box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}};
            if (ended) drawn.fill(corners, with_alpha(colour::cells, still ? 0.06 : 0.16));
        }
    }
};

bool same(const TraceItem& a, const std::string& name_in_a, const TraceItem& b, const char* name_in_b) {
    const TraceValue *x = a.find(name_in_a), *y = b.find(name_in_b);
    return x == nullptr ? y == nullptr : y != nullptr && *x == *y;
}

/// The search to which a test belongs: of the same ball, or of the same primitive of a part.
const TraceItem* search_of(const TraceStage& stage, const TraceItem& test) {
    const std::string start = test.kind == "search" ? "" : "search_of_";
    const auto at = std::ranges::find_if(stage.items, [&](const TraceItem& item) {
        return item.kind == "search" && same(test, start + "ball", item, "ball") &&
               same(test, start + "part", item, "part") && same(test, start + "primitive", item, "primitive");
    });
    return at == stage.items.end() ? nullptr : &*at;
}

std::string name_of_searcher(const TraceItem& search) {
    const TraceValue* ball = search.find("ball");
    return ball != nullptr ? "ball " + in_brief(*ball) : printable(search.get<std::string>("part"));
}

}  // namespace

void draw_cells(const Construction& drawn) {
    const TraceItem& item = drawn.item;
    if (item.kind == "cell") {
        if (item.find("level") != nullptr) TreeView{drawn, item.get<bool>("of_still")}.family(item);
        return;
    }
    const TraceItem* search = search_of(drawn.stage, item);
    if (search == nullptr) return;
    TreeView{drawn, false}.visited(search->get<std::vector<double>>("cells"));
    TreeView{drawn, true}.visited(search->get<std::vector<double>>("still_cells"));
    const auto* found = drawn.value<std::int64_t>("cell");
    if (found == nullptr) return;
    const TreeView tree{drawn, item.get<bool>("of_still")};
    if (const TraceItem* cell = tree.find(*found)) {
        drawn.frame(cell->get<Box>("box"), 3, colour::lit);
        tree.note(*cell,
                  TreeView::level_and_index(*cell) + ": found in the search of " + name_of_searcher(*search),
                  colour::lit);
    }
}

}  // namespace flipside::app

/// What is picked in the edit mode, and what is done to all of it at once.

#include <algorithm>

#include "app/window/editor/editor.hpp"

namespace flipside::app {

namespace {

using Kind = lab::Item::Kind;

}  // namespace

bool Editor::is_selected(const lab::Item& item) const {
    return std::ranges::find(selection_, item) != selection_.end();
}

lab::Item Editor::selected() const {
    return selection_.empty() ? lab::Item{Kind::bounds, 0} : selection_.back();
}

void Editor::select(const lab::Item& item) {
    selection_.clear();
    if (item.kind != Kind::bounds) selection_.push_back(item);
}

void Editor::select_one_more_or_less(const lab::Item& item) {
    if (std::erase(selection_, item) == 0) selection_.push_back(item);
}

std::vector<lab::Item> Editor::all_items() const {
    std::vector<lab::Item> items;
    const Scene& scene = draft_->sketch();
    for (std::size_t i = 0; i < scene.parts.size(); ++i) items.push_back({Kind::part, i});
    for (std::size_t i = 0; i < scene.balls.size(); ++i) items.push_back({Kind::ball, i});
    if (scene.launcher) items.push_back({Kind::launcher, 0});
    return items;
}

void Editor::select_all() {
    take(lab::tools().front());
    selection_ = all_items();
}

void Editor::select_next(int by) {
    const std::vector<lab::Item> items = all_items();
    if (items.empty()) return;
    const auto count = static_cast<std::ptrdiff_t>(items.size());
    const auto at = std::ranges::find(items, selected()) - items.begin();
    const std::ptrdiff_t next = at == count ? (by > 0 ? 0 : count - 1) : (at + by + count) % count;
    select(items[static_cast<std::size_t>(next)]);
    take(lab::tools().front());
}

void Editor::keep_selection_valid() {
    std::erase_if(selection_, [&](const lab::Item& item) { return draft_->find(item) == nullptr; });
}

void Editor::nudge(Vec2 by) {
    if (selection_.empty()) return;
    draft_->end_step();
    draft_->move(selection_, by);
    draft_->end_step();
}

void Editor::remove_selected() {
    if (selection_.empty()) return;
    drag_.reset();
    draft_->end_step();
    // From the last on, so that the others keep their places in the lists.
    std::ranges::sort(selection_, std::greater{}, &lab::Item::index);
    for (const lab::Item& item : selection_) draft_->remove(item);
    draft_->end_step();
    selection_.clear();
}

/// The launcher stays the only one.
void Editor::duplicate_selected() {
    std::erase_if(selection_, [](const lab::Item& item) { return item.kind == Kind::launcher; });
    if (selection_.empty()) return;
    drag_.reset();
    draft_->end_step();
    // Seen apart from the first ones at any zoom: by some pitches, and more for a ball.
    double by = 2 * pitch;
    for (const lab::Item& item : selection_)
        if (item.kind == Kind::ball) by = std::max(by, 2.5 * draft_->sketch().balls[item.index].radius);
    for (lab::Item& item : selection_) item = draft_->duplicate(item, {by, -by});
    draft_->end_step();
}

}  // namespace flipside::app

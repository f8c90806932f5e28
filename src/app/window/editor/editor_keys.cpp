/// What keys do in the edit mode.

#include "app/window/editor/editor_keys.hpp"

#include <algorithm>
#include <string>

#include "app/window/editor/editor.hpp"

namespace flipside::app {

namespace {

using Key = sf::Keyboard;

/// Those that mean the same as ever.
bool is_window_key(const sf::Event::KeyEvent& key) {
    constexpr Key::Key always[] = {Key::F1, Key::F2, Key::F3, Key::F4, Key::F12};
    constexpr Key::Key with_ctrl[] = {Key::Equal,    Key::Add,  Key::Hyphen,
                                      Key::Subtract, Key::Num0, Key::Numpad0};
    return std::ranges::find(always, key.code) != std::end(always) ||
           (key.control && std::ranges::find(with_ctrl, key.code) != std::end(with_ctrl));
}

}  // namespace

std::vector<std::pair<std::string, std::string>> edit_key_lines() {
    std::vector<std::pair<std::string, std::string>> lines{
        {"F4", "Leave the edit mode and play what is drawn"},
        {"Click", "Pick a part, ball or launcher; the ground: the table itself"},
        {"Shift click", "Pick one thing more, or one less"},
        {"Ctrl A", "Pick everything"},
        {"Drag", "Move it, or pull at a handle; the ground: move the view"},
        {"Wheel", "Zoom"},
        {"Ctrl, held", "No snapping"},
        {"Tab", "Pick the next thing (Shift: the one before)"},
        {"← → ↑ ↓", "Move what is picked by a step of the grid (Ctrl: a tenth)"},
        {"Delete", "Take it away; over a corner, take that away"},
        {"Ctrl D", "One more of it"},
        {"Ctrl Z", "Undo"},
        {"Ctrl Shift Z", "Do it again (Ctrl Y too)"},
        {"Ctrl S", "Save (Shift: under another name)"},
        {"Enter", "End the walls or polygon that is drawn"},
        {"Esc", "Stop drawing, or pick nothing"},
        {"F3", "All scenes"},
        {"F12", "Save a picture of the window"}};
    for (const lab::Tool& tool : lab::tools())
        lines.emplace_back(std::string(1, tool.letter), tool.stem.empty() && tool.name == "Select"
                                                            ? "Pick and move"
                                                            : "Draw: " + std::string(tool.name));
    return lines;
}

bool Editor::press_key(const sf::Event::KeyEvent& key, const Pointing& pointing) {
    if (is_window_key(key)) return false;
    const double step = key.control ? 0.1 * pitch : pitch;
    switch (key.code) {
        case Key::Escape:
            return escape();
        case Key::Enter:
            finish_pen();
            return true;
        case Key::Delete:
        case Key::BackSpace:
            remove_corner_or_selected(pointing);
            return true;
        case Key::Tab:
            select_next(key.shift ? -1 : 1);
            return true;
        case Key::Left:
            nudge({-step, 0});
            return true;
        case Key::Right:
            nudge({step, 0});
            return true;
        case Key::Up:
            nudge({0, step});
            return true;
        case Key::Down:
            nudge({0, -step});
            return true;
        default:
            break;
    }
    if (key.control) return press_with_ctrl(key);
    for (const lab::Tool& tool : lab::tools())
        if (key.code == static_cast<Key::Key>(tool.letter - 'A')) take(tool);
    return true;
}

bool Editor::press_with_ctrl(const sf::Event::KeyEvent& key) {
    if (key.code == Key::Z) key.shift ? redo() : undo();
    if (key.code == Key::Y) redo();
    if (key.code == Key::A) select_all();
    if (key.code == Key::D) duplicate_selected();
    if (key.code == Key::S) (key.shift ? save_as_wanted : save_wanted) = true;
    return true;
}

bool Editor::escape() {
    if (!pen_.empty())
        pen_.clear();
    else if (draws())
        take(lab::tools().front());
    else
        selection_.clear();
    return true;
}

void Editor::remove_corner_or_selected(const Pointing& pointing) {
    const Vec2 in_pane = mouse_pixel_ - Vec2{pointing.pane.x, pointing.pane.y};
    const auto handle = handle_at(in_pane, pointing.camera, pointing.scale);
    if (handle && handle->role == lab::Role::corner) {
        const lab::OrderedJson& before = *draft_->find(selected());
        const lab::OrderedJson after = lab::without_corner(before, handle->index);
        if (after != before) {
            draft_->end_step();
            draft_->replace(selected(), after);
            return draft_->end_step();
        }
    }
    remove_selected();
}

}  // namespace flipside::app

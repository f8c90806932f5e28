/// The edit mode and the scene browser in the window.

#include "app/window/app.hpp"
#include "app/window/editor/editor_keys.hpp"
#include "app/window/editor/editor_report.hpp"
#include "app/window/editor/editor_view.hpp"
#include "app/window/help.hpp"
#include "lab/files/assets.hpp"

namespace flipside::app {

/// As if all keys that are down were let go.
void App::let_keys_go() {
    const std::set<sf::Keyboard::Key> keys = held_;
    for (const sf::Keyboard::Key key : keys) press(action_of(key), key, false);
}

/// True where nothing would be lost by it, or the user asks for the same thing again.
bool App::may_discard(const std::string& to_do) {
    const std::string asked =
        editor_.unsaved() ? to_do + ": " + editor_.draft().document().text() : std::string();
    if (asked.empty() || discarding_ == asked) {
        forget_question();
        return true;
    }
    discarding_ = asked;
    controls_.notice = "\"" + editor_.draft().sketch().name +
                       "\" is not saved. Save it (Ctrl S), or do the same again to give it up.";
    controls_.panel_open = true;  // where it is to be read
    browser_.warn(controls_.notice.words());
    question_ = controls_.notice.words();
    return false;
}

/// What is saved or given up is not asked about any more.
void App::forget_question() {
    discarding_.clear();
    if (!question_.empty() && controls_.notice.words() == question_) controls_.notice.clear();
    question_.clear();
}

void App::close() {
    if (may_discard("close")) window_.close();
    // Where it can be saved.
    if (window_.isOpen() && !editor_.on() && editor_.name() == stage_.scene_name()) begin_edit();
}

void App::begin_edit() {
    if (editor_.name() != stage_.scene_name() && !may_discard("draw " + stage_.scene_name())) return;
    let_keys_go();
    try {
        editor_.begin(stage_);
        editor_panel_.reset();
        controls_.help_open = controls_.by_keys = false;
        hand_ = {};
        mouse_.fit();
    } catch (const std::exception& error) {
        controls_.notice = error.what();
    }
}

void App::begin_new_scene() {
    if (!may_discard("new")) return;
    editor_.begin_new();
    editor_panel_.reset();
    mouse_.fit();
}

/// What is drawn comes to all panes, and can be played at once.
void App::end_edit() {
    editor_.draft().end_step();
    if (const auto& problem = editor_.draft().problem()) {
        controls_.notice = "Cannot be played yet: " + problem->words;
        return;
    }
    const std::shared_ptr<const Scene>& scene = editor_.draft().scene();
    try {
        if (editor_.name() != stage_.scene_name() || *scene->document != *stage_.scene().document)
            stage_.take(editor_.name(), scene);
    } catch (const std::exception& error) {
        controls_.notice = error.what();
        return;
    }
    if (!stage_.is_lesson()) lessons_.close(controls_);
    editor_.leave();
    state_.edit.clear();
    controls_.help_open = false;
    controls_.table_wanted = true;
    mouse_.fit();
    shown_scene_ = stage_.scene_name();
    scene_file_.watch(stage_.is_from_file() ? lab::scene_file(shown_scene_) : "");
}

/// Its file has changed.
void App::look_after_draft() {
    if (!editor_.on() || !editor_.file_changed()) return;
    if (editor_.unsaved())
        controls_.notice =
            "The file has been changed by somebody else. Saving asks before it writes it over.";
    else
        editor_.begin(stage_);
}

/// True for what is the browser's or the edit mode's alone.
bool App::take_for_drawing(const sf::Event& event) {
    if (event.type == sf::Event::Closed) return false;
    if (browser_.is_open()) return browser_.process(event);
    if (!editor_.on()) return false;
    const Pointing pointing{layout_.panes.front(),
                            camera_,
                            scale_,
                            ImGui::GetIO().KeyCtrl,
                            ImGui::GetIO().KeyShift,
                            clock_.getElapsedTime().asSeconds()};
    if (controls_.help_open && event.type == sf::Event::KeyPressed &&
        event.key.code == sf::Keyboard::Escape) {
        controls_.help_open = false;
        return true;
    }
    if (editor_.process(event, pointing)) return true;
    if (event.type == sf::Event::KeyPressed || event.type == sf::Event::KeyReleased) return false;
    mouse_.process(event, pointing.now, layout_, camera_);
    return true;
}

void App::arrange_edit() {
    layout_ = edit_layout(state_.width, state_.height, scale_, controls_.panel_open);
    camera_.size = {layout_.panes.front().width, layout_.panes.front().height};
    constexpr double margin = 30;  // px, with room for handles
    if (mouse_.fitted()) camera_.fit(view_bounds(editor_), scale_ * margin);
}

void App::draw_edit() {
    places_ = {};
    if (!editor_.unsaved()) forget_question();
    const EditorPanel::Wish wish = editor_panel_.draw(layout_.panel, editor_, controls_, places_);
    arrange_edit();
    if (!controls_.panel_open) draw_notice_on(layout_.panes.back(), controls_.notice, places_);
    if (controls_.help_open) draw_help({0, 0, state_.width, state_.height}, edit_key_lines(), places_);
    draw_browser();
    state_.edit = state_of(editor_, layout_.panes.front(), camera_);
    draw_editor(window_, screen_->canvas(), editor_, layout_, camera_);
    imgui_.end_frame();
    if (screenshot_wanted_) save_screenshot();
    if (wish == EditorPanel::Wish::leave) end_edit();
    if (wish == EditorPanel::Wish::browse) browse();
    if (wish == EditorPanel::Wish::new_scene) begin_new_scene();
}

void App::browse() {
    let_keys_go();
    browser_.open(editor_.on() ? editor_.name() : stage_.scene_name());
}

void App::draw_browser() {
    state_.browser = browser_.is_open();
    if (!browser_.is_open()) return;
    const auto chosen =
        browser_.draw({0, 0, state_.width, state_.height}, screen_->canvas().lettering(), places_);
    if (chosen) open_chosen(*chosen);
}

void App::open_chosen(const std::string& scene) {
    try {
        if (editor_.on()) {
            if (!may_discard("open " + scene)) return;
            editor_.begin_file(scene);
            editor_panel_.reset();
            mouse_.fit();
        } else {
            stage_.open(scene);
            lessons_.close(controls_);
        }
        controls_.notice.clear();
        browser_.close();
    } catch (const std::exception& error) {
        browser_.warn(error.what());
    }
}

}  // namespace flipside::app

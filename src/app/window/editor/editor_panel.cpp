#include "app/window/editor/editor_panel.hpp"

#include <cmath>
#include <utility>

#include "app/window/editor/editor_fields.hpp"
#include "app/window/editor/text_field.hpp"
#include "app/window/editor/tool_icons.hpp"
#include "app/window/panel_parts.hpp"
#include "app/window/words.hpp"
#include "lab/process/failure.hpp"
#include "world/printable.hpp"

namespace flipside::app {

namespace {

/// As wide as `share` of what is left of the line.
bool edit_button(ControlPlaces& places, const char* words, const char* meaning, double share = 1,
                 bool enabled = true) {
    const double room = ImGui::GetContentRegionAvail().x, gap = ImGui::GetStyle().ItemSpacing.x;
    if (!enabled) ImGui::BeginDisabled();
    const bool pressed = ImGui::Button(words, imgui_vector(std::floor((room + gap) * share - gap), 0));
    if (!enabled) ImGui::EndDisabled();
    tooltip(meaning);
    note(places, words);
    return pressed;
}

/// No file is written that no engine could read.
bool may_save(Editor& editor, WindowControls& controls) {
    editor.draft().end_step();
    const auto& problem = editor.draft().problem();
    if (problem) controls.notice = "Not saved, for no engine could run it: " + problem->words;
    return !problem;
}

void draw_palette(Editor& editor, ControlPlaces& places) {
    constexpr int columns = 4;
    const float gap = 0.3F * ImGui::GetFontSize();
    const float width = std::floor((ImGui::GetContentRegionAvail().x - gap * (columns - 1)) / columns);
    int i = 0;
    for (const lab::Tool& tool : lab::tools()) {
        if (i++ % columns != 0) ImGui::SameLine(0, gap);
        if (tool_button(tool, &tool == &editor.tool(), width)) editor.take(tool);
        tooltip(std::string(tool.hint) + " (" + tool.letter + ")");
        note(places, std::string(tool.name));
    }
}

void draw_grid_controls(Editor& editor, ControlPlaces& places) {
    label("Grid", "How far its lines are apart; points snap to it");
    const auto in_words = [](double pitch) {
        return pitch < 1 ? with_unit(1000 * pitch, 0, "mm") : with_unit(pitch, 0, "m");
    };
    ImGui::SetNextItemWidth(5.5F * ImGui::GetFontSize());
    if (ImGui::BeginCombo("##pitch", in_words(editor.pitch).c_str())) {
        for (const double pitch : lab::pitches()) {
            if (ImGui::Selectable(in_words(pitch).c_str(), pitch == editor.pitch)) editor.pitch = pitch;
            note(places, "grid " + in_words(pitch));
        }
        ImGui::EndCombo();
    }
    note(places, "Grid");
    ImGui::SameLine();
    ImGui::Checkbox("Snap", &editor.snaps);
    tooltip("To ends, the grid and angles of 15°; hold Ctrl to do without for a moment");
    note(places, "Snap");
}

}  // namespace

EditorPanel::Wish EditorPanel::draw(const Rect& place, Editor& editor, WindowControls& controls,
                                    ControlPlaces& places) {
    Wish wish = Wish::none;
    ImGui::SetNextWindowPos(imgui_vector(place.x, place.y));
    ImGui::SetNextWindowSize(imgui_vector(place.width, place.height));
    if (!controls.panel_open) ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {3, 8});
    ImGui::Begin("edit controls", nullptr, docked & ~ImGuiWindowFlags_NoScrollbar);
    if (!controls.panel_open) {
        if (edit_button(places, "«", "Open the controls (F2)")) controls.panel_open = true;
        ImGui::End();
        ImGui::PopStyleVar();
        return wish;
    }
    if (edit_button(places, "Play", "Leave the edit mode: what is drawn comes to all engines (F4)", 0.4))
        wish = Wish::leave;
    ImGui::SameLine();
    if (edit_button(places, "Help", "Every key (F1)", 0.6)) controls.help_open = !controls.help_open;
    ImGui::SameLine();
    if (edit_button(places, "»", "Fold the controls away (F2)")) controls.panel_open = false;
    draw_notice(controls.notice, places);
    draw_file(editor, controls, places, wish);
    if (region("Draw")) draw_palette(editor, places);
    draw_grid_controls(editor, places);
    draw_properties(editor, places);
    ImGui::End();
    return wish;
}

void EditorPanel::draw_file(Editor& editor, WindowControls& controls, ControlPlaces& places, Wish& wish) {
    if (edit_button(places, "Save", "To its file (Ctrl S)", 0.25)) editor.save_wanted = true;
    ImGui::SameLine();
    if (edit_button(places, "Save as", "To another file (Ctrl Shift S)", 1.0 / 3))
        editor.save_as_wanted = true;
    ImGui::SameLine();
    if (edit_button(places, "New", "An empty table", 0.5)) wish = Wish::new_scene;
    ImGui::SameLine();
    if (edit_button(places, "Scenes", "All scenes, with pictures (F3)")) wish = Wish::browse;
    const lab::Document& document = editor.draft().document();
    if (edit_button(places, "Undo", "Ctrl Z", 0.5, document.can_undo())) editor.undo();
    ImGui::SameLine();
    if (edit_button(places, "Redo", "Ctrl Shift Z", 1, document.can_redo())) editor.redo();
    const bool here = std::exchange(editor.save_wanted, false);
    const bool elsewhere = std::exchange(editor.save_as_wanted, false);
    if ((here || elsewhere) && may_save(editor, controls)) {
        if (elsewhere)
            choose_name(editor, "");
        else
            save(editor, controls);
    }
    if (choosing_) draw_save_as(editor, controls, places);
}

void EditorPanel::save(Editor& editor, WindowControls& controls) {
    if (!editor.own()) return choose_name(editor, "");
    switch (lab::obstacle_to(editor.own()->file, editor.own())) {
        case lab::SaveObstacle::shipped:
            return choose_name(editor,
                               "This scene comes with Flipside and stays as it is. Save your own under "
                               "another name.");
        case lab::SaveObstacle::none:
            return write(editor, editor.own()->file, controls);
        default:
            choose_name(editor, "Somebody else has changed the file since it was read.");
            typed_ = editor.own()->file.string();
    }
}

void EditorPanel::choose_name(const Editor& editor, std::string why) {
    choosing_ = begins_ = true;
    why_ = std::move(why);
    std::string stem;
    for (const char c : editor.draft().sketch().name)
        stem += (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ? c : '-';
    std::error_code unknown;
    typed_ =
        lab::free_scene_file(std::filesystem::current_path(unknown), stem.empty() ? "scene" : stem).string();
}

void EditorPanel::draw_save_as(Editor& editor, WindowControls& controls, ControlPlaces& places) {
    if (!why_.empty()) wrapped(why_);
    ImGui::TextUnformatted("File");
    ImGui::SetNextItemWidth(-1);
    if (std::exchange(begins_, false)) ImGui::SetKeyboardFocusHere();
    const bool entered = text_field("##file", typed_, 1000, true);
    note(places, "File");
    const std::filesystem::path file = lab::typed_file(typed_);
    const lab::SaveObstacle obstacle =
        typed_.empty() ? lab::SaveObstacle::none : lab::obstacle_to(file, editor.own());
    const bool taken = obstacle != lab::SaveObstacle::none;
    if (taken) wrapped("There is such a file already.", colour::warning);
    const bool pressed =
        edit_button(places, taken ? "Replace it" : "Save here",
                    taken ? "What is in the file is lost" : "Write the file", 0.5, !typed_.empty());
    ImGui::SameLine();
    if (edit_button(places, "Cancel", "Do not save")) choosing_ = false;
    if (pressed || (entered && !taken && !typed_.empty())) write(editor, file, controls);
}

void EditorPanel::write(Editor& editor, const std::filesystem::path& file, WindowControls& controls) {
    if (!may_save(editor, controls)) return;
    try {
        editor.save_to(file);
        choosing_ = false;
        controls.notice.tell("Saved " + editor.own()->file.string());
    } catch (const std::runtime_error& error) {
        controls.notice = error.what();
    }
}

}  // namespace flipside::app

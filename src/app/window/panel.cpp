#include "app/window/panel.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/window/keys.hpp"
#include "app/window/panel_parts.hpp"
#include "app/window/words.hpp"
#include "lab/assets.hpp"
#include "world/printable.hpp"

namespace flipside::app {

namespace {

bool slider(const char* id, double& value, double min, double max, const char* format,
            ImGuiSliderFlags flags = 0) {
    return ImGui::SliderScalar(id, ImGuiDataType_Double, &value, &min, &max, format,
                               flags | ImGuiSliderFlags_AlwaysClamp);
}

/// Of a thing called by the name of a file. ImGui would take ## and what follows for an id and not show it.
std::string label_of(const std::string& name) {
    std::string shown = printable(name);
    for (auto at = shown.find("##"); at != std::string::npos; at = shown.find("##", at))
        shown.insert(at + 1, 1, ' ');
    return shown;
}

struct PanelParts {
    Stage& stage;
    WindowControls& controls;
    ControlPlaces& places;
    Lessons& lessons;

    bool tab(const char* words, bool wanted) const {
        const bool open = ImGui::BeginTabItem(words, nullptr, wanted ? ImGuiTabItemFlags_SetSelected : 0);
        note(places, words);
        return open;
    }
    void all(const Load& load) const;

    bool button(const char* words, const char* meaning, double share = 1) const {
        const double room = ImGui::GetContentRegionAvail().x;
        const double gap = ImGui::GetStyle().ItemSpacing.x;
        const bool pressed = ImGui::Button(words, imgui_vector(std::floor((room + gap) * share - gap), 0));
        tooltip(meaning);
        note(places, words);
        return pressed;
    }
    void toggle(const char* words, bool& on, std::string_view meaning) const {
        ImGui::Checkbox(words, &on);
        tooltip(meaning);
        note(places, words);
    }
    void scene_chooser() const {
        ImGui::SetNextItemWidth(-1);
        const std::string shown =
            printable(stage.scene().name.empty() ? stage.scene_name() : stage.scene().name);
        if (ImGui::BeginCombo("##scene", shown.c_str())) {
            for (const std::string& name : lab::scene_names())
                if (ImGui::Selectable(label_of(name).c_str(), name == stage.scene_name())) open(name);
            ImGui::EndCombo();
        }
        tooltip(stage.scene().about.empty() ? "The scene on the table" : printable(stage.scene().about));
        note(places, "Scene");
        if (!controls.notice.empty()) {
            ImGui::PushStyleColor(ImGuiCol_Text, imgui_color(colour::warning));
            ImGui::TextWrapped("%s", printable(controls.notice).c_str());
            ImGui::PopStyleColor();
        }
    }
    void open(const std::string& name) const {
        try {
            stage.open(name);
            lessons.close(controls);
            controls.notice.clear();
        } catch (const std::exception& error) {
            controls.notice = error.what();
        }
    }
    void views() const {
        static constexpr std::pair<View, const char*> all[] = {
            {View::single, "Single"}, {View::split, "Split"}, {View::overlay, "Overlay"}};
        const double room = ImGui::GetContentRegionAvail().x, gap = ImGui::GetStyle().ItemSpacing.x;
        for (const auto& [view, name] : all) {
            const bool chosen = stage.view() == view;
            ImGui::PushStyleColor(ImGuiCol_Button,
                                  ImGui::GetStyleColorVec4(chosen ? ImGuiCol_ButtonActive : ImGuiCol_Button));
            if (ImGui::Button(name, imgui_vector(std::floor((room - 2 * gap) / 3), 0))) stage.set_view(view);
            ImGui::PopStyleColor();
            tooltip("One engine, all side by side, or all on one table (V, or 1, 2, 3)");
            note(places, name);
            if (view != View::overlay) ImGui::SameLine();
        }
    }
    void reference() const {
        bool on = stage.reference();
        toggle("Reference", on,
               "The exact engine, in green: how far are the others from the truth? Its balls fade as its own "
               "certainty ends, and it stops where it cannot be exact (E)");
        if (!stage.show_reference(on)) controls.notice = no_room;
        if (!stage.reference()) return;
        ImGui::SameLine();
        if (button("Take up again", "Let the reference go on from the state of the first of the others (T)"))
            stage.take_up();
    }
    void time() const {
        if (button(controls.paused ? "Go on" : "Pause", "P", 1.0 / 3)) controls.paused = !controls.paused;
        ImGui::SameLine();
        if (button("Step", "Pause and take one step (.)", 0.5)) {
            controls.paused = true;
            ++controls.single_steps;
        }
        ImGui::SameLine();
        if (button("Restart", "R")) stage.restart();
        toggle("Inside a step", controls.bar_open,
               "Walk through the stages of a step, on any engine: . for the next stage, , for the one before "
               "(I)");
        label("Time", "Simulated seconds per second of yours; S for slow motion");
        slider("##speed", controls.speed, 0.01, 2, "%.2f ×", ImGuiSliderFlags_Logarithmic);
        note(places, "Time");
    }
    void next_ball() const {
        const Launcher& launcher = *stage.scene().launcher;
        const double span = launcher.fastest - launcher.slowest;
        label("Size", "Radius of the next ball launched, mm; its mass grows with the cube of it");
        double radius = 1000 * launcher.ball.radius * controls.launch_size;
        if (slider("##size", radius, 500 * launcher.ball.radius, 2000 * launcher.ball.radius, "%.1f mm"))
            controls.launch_size = radius / (1000 * launcher.ball.radius);
        label("Speed", "Speed at which the button launches, m/s; Space charges its own");
        double speed = launcher.slowest + span * controls.launch_strength;
        if (slider("##strength", speed, launcher.slowest, launcher.fastest, "%.2f m/s") && span > 0)
            controls.launch_strength = (speed - launcher.slowest) / span;
        label("Balls", "How many to launch one after another, 1 to 1,000");
        ImGui::SliderInt("##count", &controls.launch_count, 1, 1000, "%d",
                         ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp);
        if (button("Launch", "Launch them, each as soon as its place is free", 0.5))
            stage.press(
                control::Launch{controls.launch_strength, controls.launch_count, controls.launch_size});
    }
    void table() const {
        const auto& parts = stage.scene().parts;
        const bool turns = std::ranges::any_of(
            parts, [](const Part& part) { return std::holds_alternative<motion::Turn>(part.motion); });
        if (stage.scene().launcher) {
            next_ball();
            ImGui::SameLine();
        }
        if (button("Clear", "Take every ball off the table")) stage.clear();
        if (turns) {
            bool rotating = stage.runs().front().session().world().save().rotating;
            const bool before = rotating;
            toggle("Rotate", rotating, "Let the turning parts turn");
            if (rotating != before) stage.press(control::Rotate{rotating});
            ImGui::SameLine();
        }
        if (stage.has_gravity()) {
            bool gravity = stage.gravity();
            toggle("Gravity", gravity, "The scene's gravity, or none");
            stage.set_gravity(gravity);
            ImGui::SameLine();
        }
        toggle("Random colours", controls.look.random_colours, "Tint each ball, to tell them apart");
    }
    void shows() const {
        if (!ImGui::BeginTable("shows", 2)) return;
        for (std::size_t i = 0; i < show_count; ++i) {
            ImGui::TableNextColumn();
            bool on = controls.look.shows[i];
            toggle(std::string(show_specs[i].label).c_str(), on, show_specs[i].about);
            controls.look.shows[i] = on;
        }
        ImGui::EndTable();
    }
};

void draw_load(const Load& load) {
    label("Frames", "Pictures drawn per second, over the last second");
    ImGui::Text("%.0f per second", load.frames_per_second);
    label("Busy", "Share of each frame's time that the program works; the engines' part of it");
    const std::string words =
        with_unit(100 * load.busy, 0, "%") + ", engines " + with_unit(100 * load.physics, 1, "%");
    ImGui::ProgressBar(static_cast<float>(load.busy), {-1, 0}, words.c_str());
}

void PanelParts::all(const Load& load) const {
    scene_chooser();
    views();
    reference();
    time();
    if (region("Balls and table")) table();
    if (region("Show")) shows();
    draw_settings(stage, places, controls.notice);
    draw_counts(stage);
    if (region("Load")) draw_load(load);
}

}  // namespace

ControlPlaces draw_panel(const Rect& place, Stage& stage, WindowControls& controls, Lessons& lessons,
                         const Load& load) {
    ControlPlaces places;
    ImGui::SetNextWindowPos(imgui_vector(place.x, place.y));
    ImGui::SetNextWindowSize(imgui_vector(place.width, place.height));
    if (!controls.panel_open) ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {3, 8});
    ImGui::Begin("controls", nullptr, docked & ~ImGuiWindowFlags_NoScrollbar);
    const PanelParts parts{stage, controls, places, lessons};
    if (!controls.panel_open) {
        if (parts.button("«", "Open the controls (F2)")) controls.panel_open = true;
        ImGui::End();
        ImGui::PopStyleVar();
        return places;
    }
    ImGui::PushFont(ImGui::GetIO().Fonts->Fonts[1]);
    ImGui::TextUnformatted("Flipside");
    ImGui::PopFont();
    ImGui::SameLine(ImGui::GetContentRegionMax().x - 5 * ImGui::GetFontSize());
    if (parts.button("Help", "Every key (F1)", 0.66)) controls.help_open = !controls.help_open;
    ImGui::SameLine();
    if (parts.button("»", "Fold the controls away (F2)")) controls.panel_open = false;
    if (ImGui::BeginTabBar("tabs")) {
        if (parts.tab("Controls", false)) {
            parts.all(load);
            ImGui::EndTabItem();
        }
        if (parts.tab("Lessons", std::exchange(controls.lesson_wanted, false))) {
            lessons.draw(stage, controls, places);
            ImGui::EndTabItem();
        }
        ImGui::EndTabBar();
    }
    ImGui::End();
    return places;
}

void draw_help(const Rect& place) {
    ImGui::SetNextWindowPos(imgui_vector(place.x + place.width / 2, place.y + place.height / 2),
                            ImGuiCond_Always, {0.5F, 0.5F});
    ImGui::SetNextWindowBgAlpha(0.96F);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {22, 12});
    ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, {6, 1});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 8);
    ImGui::Begin("help", nullptr, docked | ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoInputs);
    ImGui::PushFont(ImGui::GetIO().Fonts->Fonts[1]);
    ImGui::TextUnformatted("Keys");
    ImGui::PopFont();
    if (ImGui::BeginTable("keys", 2, ImGuiTableFlags_SizingFixedFit)) {
        const auto row = [](std::string_view keys, std::string_view meaning) {
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(keys.data(), keys.data() + keys.size());
            ImGui::TableNextColumn();
            ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
            ImGui::TextUnformatted(meaning.data(), meaning.data() + meaning.size());
            ImGui::PopStyleColor();
        };
        for (const KeyUse& use : key_uses()) row(use.names, use.meaning);
        row("Wheel, drag", "Zoom, move the table");
        row("Double click", "Fit the table to its pane");
        ImGui::EndTable();
    }
    ImGui::End();
    ImGui::PopStyleVar(3);
}

}  // namespace flipside::app

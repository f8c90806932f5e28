#include <algorithm>

#include "app/window/panel_tabs.hpp"
#include "lab/files/assets.hpp"
#include "world/printable.hpp"

namespace flipside::app {

namespace {

/// Of a thing called by the name of a file. ImGui would take ## and what follows for an id and not show it.
std::string label_of(const std::string& name) {
    std::string shown = printable(name);
    for (auto at = shown.find("##"); at != std::string::npos; at = shown.find("##", at))
        shown.insert(at + 1, 1, ' ');
    return shown;
}

void open_scene(const Panel& panel, const std::string& name) {
    try {
        panel.stage.open(name);
        panel.lessons.close(panel.controls);
        panel.controls.notice.clear();
    } catch (const std::exception& error) {
        panel.controls.notice = error.what();
    }
}

void scene_chooser(const Panel& panel) {
    const Stage& stage = panel.stage;
    ImGui::SetNextItemWidth(-1);
    const std::string shown = printable(stage.scene().name.empty() ? stage.scene_name() : stage.scene().name);
    if (ImGui::BeginCombo("##scene", shown.c_str(), ImGuiComboFlags_HeightLarge)) {
        for (const std::string& name : lab::scene_names()) {
            if (ImGui::Selectable(label_of(name).c_str(), name == stage.scene_name()))
                open_scene(panel, name);
            note(panel.places, "scene " + name);
        }
        ImGui::EndCombo();
    }
    tooltip(stage.scene().about.empty() ? "The scene on the table" : printable(stage.scene().about));
    note(panel.places, "Scene");
    if (panel.button("All scenes", "With pictures and a sentence each (F3)", 0.5))
        panel.controls.browse_wanted = true;
    ImGui::SameLine();
    if (panel.button("Draw", "Move, add and remove parts by hand (F4)")) panel.controls.edit_wanted = true;
}

void time_controls(const Panel& panel) {
    WindowControls& controls = panel.controls;
    if (panel.button(controls.paused ? "Go on" : "Pause", "P", 1.0 / 3)) controls.paused = !controls.paused;
    ImGui::SameLine();
    if (panel.button("Step", "Pause and take one step (.)", 0.5)) {
        controls.paused = true;
        ++controls.single_steps;
    }
    ImGui::SameLine();
    if (panel.button("Restart", "R")) panel.stage.restart();
    if (panel.button(panel.stage.scene().rules ? "Save this game" : "Save this run",
                     "As a replay, to play it again to the bit, or to share it (F5)"))
        controls.save_wanted = true;
    panel.toggle("Inside a step", controls.bar_open,
                 "Walk through the stages of a step, on any engine: . for the next stage, , for the one "
                 "before (I)");
    label("Time", "Simulated seconds per second of yours; S for slow motion");
    slider("##speed", controls.speed, 0.01, 2, "%.2f ×", ImGuiSliderFlags_Logarithmic);
    note(panel.places, "Time");
}

void next_ball(const Panel& panel) {
    WindowControls& controls = panel.controls;
    const Launcher& launcher = *panel.stage.scene().launcher;
    const double span = launcher.fastest - launcher.slowest;
    label("Size", "Radius of the next ball launched, mm; its mass grows with the cube of it");
    double radius = 1000 * launcher.ball.radius * controls.launch_size;
    if (slider("##size", radius, 500 * launcher.ball.radius, 2000 * launcher.ball.radius, "%.1f mm"))
        controls.launch_size = radius / (1000 * launcher.ball.radius);
    note(panel.places, "Size");
    label("Speed", "Speed at which the button launches, m/s; Space charges its own");
    double speed = launcher.slowest + span * controls.launch_strength;
    if (slider("##strength", speed, launcher.slowest, launcher.fastest, "%.2f m/s") && span > 0)
        controls.launch_strength = (speed - launcher.slowest) / span;
    note(panel.places, "Speed");
    label("Balls", "How many to launch one after another, 1 to 1,000");
    slider("##count", controls.launch_count, 1, 1000, ImGuiSliderFlags_Logarithmic);
    note(panel.places, "Balls");
    if (panel.button("Launch", "Launch them, each as soon as its place is free", 0.5))
        panel.stage.press(
            control::Launch{controls.launch_strength, controls.launch_count, controls.launch_size});
    ImGui::SameLine();
}

void ball_controls(const Panel& panel) {
    Stage& stage = panel.stage;
    if (stage.scene().launcher) next_ball(panel);
    if (panel.button("Clear", "Take every ball off the table")) stage.clear();
    const bool turns = std::ranges::any_of(stage.scene().parts, [](const Part& part) {
        return std::holds_alternative<motion::Turn>(part.motion);
    });
    if (stage.has_gravity()) {
        bool gravity = stage.gravity();
        panel.toggle("Gravity", gravity, "The scene's gravity, or none");
        stage.set_gravity(gravity);
        if (turns) ImGui::SameLine();
    }
    if (!turns) return;
    bool rotating = stage.runs().front().session().world().save().rotating;
    const bool before = rotating;
    panel.toggle("Rotate", rotating, "Let the turning parts turn");
    if (rotating != before) stage.press(control::Rotate{rotating});
}

}  // namespace

void draw_table_tab(const Panel& panel) {
    scene_chooser(panel);
    if (region("Run")) time_controls(panel);
    if (region("Balls and table")) ball_controls(panel);
}

}  // namespace flipside::app

#include "app/window/contender_choice.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "app/window/panel_parts.hpp"
#include "app/window/words.hpp"
#include "world/input_error.hpp"

namespace flipside::app {

namespace {

constexpr int steps_per_second[] = {15, 30, 60, 120, 240, 480, 960};

/// A refusal becomes the notice.
bool done(Notice& notice, const std::function<void()>& change) {
    try {
        change();
        notice.clear();
        return true;
    } catch (const InputError& error) {
        notice = error.what();
        return false;
    }
}

/// The steps there are, the one of the run at `index` marked.
void list_steps(Stage& stage, std::size_t index, ControlPlaces& places, Notice& notice) {
    const double dt = stage.runs()[index].dt();
    for (const int rate : steps_per_second) {
        const bool chosen = std::abs(dt * rate - 1) < 1e-9;
        if (ImGui::Selectable(step_in_words(1.0 / rate).c_str(), chosen) && !chosen)
            done(notice, [&] { stage.change_step(index, 1.0 / rate); });
        note(places, "Step " + step_in_words(1.0 / rate));
    }
}

constexpr const char* about_step =
    "Its own time step, s. All contenders meet at the end of every step of the longest";

void choose_step_at(const Rect& place, Stage& stage, std::size_t index, ControlPlaces& places,
                    Notice& notice) {
    const std::string name = stage.runs()[index].name();
    const ImVec2 corner = imgui_vector(place.x, place.y), size = imgui_vector(place.width, place.height);
    ImGui::SetNextWindowPos(corner);
    ImGui::SetNextWindowSize(size);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
    ImGui::Begin(("step of " + name).c_str(), nullptr,
                 docked | ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoFocusOnAppearing |
                     ImGuiWindowFlags_NoBringToFrontOnFocus);
    ImGui::PopStyleVar(2);
    if (ImGui::InvisibleButton("step", size)) ImGui::OpenPopup("steps");
    if (ImGui::IsItemHovered())
        ImGui::GetWindowDrawList()->AddRect(corner, {corner.x + size.x, corner.y + size.y},
                                            ImGui::GetColorU32(ImGuiCol_Text));
    note(places, name + ": Step in the header");
    tooltip(about_step);
    ImGui::SetNextWindowPos({corner.x, corner.y + size.y});
    if (ImGui::BeginPopup("steps")) {
        list_steps(stage, index, places, notice);
        ImGui::EndPopup();
    }
    ImGui::End();
}

}  // namespace

bool choose_contender(Stage& stage, std::size_t index, ControlPlaces& places, Notice& notice) {
    const std::string name = stage.runs()[index].name();
    label("Engine", "The ball goes on with it from where it is");
    if (ImGui::BeginCombo("##engine", std::string(stage.runs()[index].engine().name).c_str())) {
        for (const Engine* engine : lab::engines()) {
            const bool chosen = engine == &stage.runs()[index].engine();
            if (ImGui::Selectable(std::string(engine->name).c_str(), chosen) && !chosen)
                done(notice, [&] { stage.change_engine(index, *engine); });
            note(places, "Engine " + std::string(engine->name));
        }
        ImGui::EndCombo();
    }
    note(places, name + ": Engine");

    label("Step", about_step);
    if (ImGui::BeginCombo("##step", step_in_words(stage.runs()[index].dt()).c_str())) {
        list_steps(stage, index, places, notice);
        ImGui::EndCombo();
    }
    note(places, name + ": Step");

    if (stage.contenders().size() == 1) return true;
    const bool removed = ImGui::Button("Take this pane away");
    note(places, name + ": Remove");
    if (!removed) return true;
    done(notice, [&] { stage.remove_contender(index); });
    return false;
}

void choose_steps_in_headers(std::span<const std::optional<Rect>> steps, Stage& stage, ControlPlaces& places,
                             Notice& notice) {
    for (std::size_t i = 0; i < std::min(steps.size(), stage.runs().size()); ++i)
        if (steps[i]) choose_step_at(*steps[i], stage, i, places, notice);
}

void add_contender(Stage& stage, ControlPlaces& places, Notice& notice) {
    if (stage.contenders().size() == Stage::most_contenders) return;
    if (ImGui::Button("Add a pane", imgui_vector(-1, 0))) done(notice, [&] { stage.add_contender(); });
    tooltip("One more contender, at first like the last one: choose its engine, its step and its settings");
    note(places, "Add a pane");
}

}  // namespace flipside::app

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
bool done(std::string& notice, const std::function<void()>& change) {
    try {
        change();
        notice.clear();
        return true;
    } catch (const InputError& error) {
        notice = error.what();
        return false;
    }
}

}  // namespace

bool choose_contender(Stage& stage, std::size_t index, ControlPlaces& places, std::string& notice) {
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

    label("Step", "Its own time step, s. All contenders meet at the end of every step of the longest");
    const double dt = stage.runs()[index].dt();
    if (ImGui::BeginCombo("##step", step_in_words(dt).c_str())) {
        for (const int rate : steps_per_second) {
            const bool chosen = std::abs(dt * rate - 1) < 1e-9;
            if (ImGui::Selectable(step_in_words(1.0 / rate).c_str(), chosen) && !chosen)
                done(notice, [&] { stage.change_step(index, 1.0 / rate); });
            note(places, "Step " + step_in_words(1.0 / rate));
        }
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

void add_contender(Stage& stage, ControlPlaces& places, std::string& notice) {
    if (stage.contenders().size() == Stage::most_contenders) return;
    if (ImGui::Button("Add a pane", imgui_vector(-1, 0))) done(notice, [&] { stage.add_contender(); });
    tooltip("One more contender, at first like the last one: choose its engine, its step and its settings");
    note(places, "Add a pane");
}

}  // namespace flipside::app

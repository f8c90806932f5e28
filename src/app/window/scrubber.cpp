#include "app/window/scrubber.hpp"

#include "app/window/panel_parts.hpp"
#include "app/window/words.hpp"

namespace flipside::app {

void draw_scrubber(const Rect& place, Stage& stage, WindowControls& controls, ControlPlaces& places) {
    ImGui::SetNextWindowPos(imgui_vector(place.x, place.y));
    ImGui::SetNextWindowSize(imgui_vector(place.width, place.height));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
    ImGui::Begin("scrubber", nullptr, docked);
    ImGui::PopStyleVar(2);  // the tooltip has room around its words
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {6, 0});
    const double begin = stage.record_begin(), end = stage.record_end();
    double time = stage.time();
    const double before = end - time;
    const std::string words =
        with_unit(time, 2, "s") + (stage.in_past() ? ",  " + with_unit(before, 2, "s") + " back" : "");
    ImGui::SetNextItemWidth(-1);
    if (ImGui::SliderScalar("##time", ImGuiDataType_Double, &time, &begin, &end, words.c_str(),
                            ImGuiSliderFlags_NoInput | ImGuiSliderFlags_NoRoundToFormat)) {
        controls.paused = true;
        stage.go_to(time);
    }
    tooltip(
        "The last half minute: drag to go back, step by step with , and . (Home and End for its ends). P "
        "goes on from there and forgets what came after");
    note(places, "Scrubber");
    ImGui::End();
    ImGui::PopStyleVar();
}

}  // namespace flipside::app

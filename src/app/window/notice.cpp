#include "app/window/notice.hpp"

#include <algorithm>

#include "app/window/panel_parts.hpp"
#include "app/window/theme.hpp"
#include "world/printable.hpp"

namespace flipside::app {

Notice& Notice::operator=(std::string_view words) {
    words_ = words;
    trouble_ = true;
    return *this;
}

void Notice::tell(std::string_view words) {
    constexpr double long_enough = 8;  // s, to read a path
    words_ = words;
    trouble_ = false;
    left_ = long_enough;
}

void Notice::pass(double seconds) {
    left_ -= seconds;
    if (!trouble_ && left_ <= 0) words_.clear();
}

void draw_notice(Notice& notice, ControlPlaces& places) {
    notice.pass(ImGui::GetIO().DeltaTime);
    if (notice.empty()) return;
    wrapped(printable(notice.words()), notice.is_trouble() ? colour::warning : colour::text);
    const bool read = ImGui::SmallButton("I see");
    note(places, "I see");
    if (read) notice.clear();
}

void draw_notice_on(const Rect& pane, Notice& notice, ControlPlaces& places) {
    if (notice.empty()) return;
    const double size = ImGui::GetFontSize(), space = 0.5 * size;
    const double width = std::min(22 * size, pane.width - 2 * space);
    ImGui::SetNextWindowPos(imgui_vector(pane.x + pane.width - space, pane.y + space), ImGuiCond_Always,
                            {1, 0});
    ImGui::SetNextWindowSize(imgui_vector(width, 0));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
    ImGui::Begin("notice", nullptr, docked | ImGuiWindowFlags_NoFocusOnAppearing);
    draw_notice(notice, places);
    ImGui::End();
    ImGui::PopStyleVar();
}

}  // namespace flipside::app

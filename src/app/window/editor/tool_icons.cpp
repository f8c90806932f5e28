#include "app/window/editor/tool_icons.hpp"

#include <string>

#include <imgui.h>

#include "app/window/panel_parts.hpp"

namespace flipside::app {

namespace {

/// In a square of about 2 × 2 about the middle, y down.
struct Icon {
    ImDrawList& list;
    ImVec2 middle;
    float unit = 1;  ///< px
    ImU32 color = 0;

    [[nodiscard]] ImVec2 at(float x, float y) const { return {middle.x + unit * x, middle.y + unit * y}; }
    void line(float ax, float ay, float bx, float by, float width = 2) const {
        list.AddLine(at(ax, ay), at(bx, by), color, width);
    }
    void path(std::initializer_list<ImVec2> points, bool closed) const {
        for (const ImVec2 p : points) list.PathLineTo(at(p.x, p.y));
        list.PathStroke(color, closed ? ImDrawFlags_Closed : ImDrawFlags_None, 2);
    }
    void ring(float x, float y, float radius) const { list.AddCircle(at(x, y), unit * radius, color, 0, 2); }
    void disc(float x, float y, float radius) const { list.AddCircleFilled(at(x, y), unit * radius, color); }
    void head(float x, float y, float dx, float dy) const {
        list.AddTriangleFilled(at(x + 0.5F * dx, y + 0.5F * dy), at(x - 0.35F * dy, y + 0.35F * dx),
                               at(x + 0.35F * dy, y - 0.35F * dx), color);
    }
    void dashes(float ax, float ay, float bx, float by) const {
        for (int i = 0; i < 4; ++i) {
            const float t = static_cast<float>(i) / 4, u = t + 0.15F;
            line(ax + t * (bx - ax), ay + t * (by - ay), ax + u * (bx - ax), ay + u * (by - ay));
        }
    }
};

void draw_icon(const Icon& icon, std::string_view name) {
    constexpr float pi = 3.14159265F;
    if (name == "Select")
        icon.path({{-0.4F, -0.9F}, {-0.4F, 0.7F}, {0, 0.3F}, {0.6F, 0.3F}}, true);
    else if (name == "Wall")
        icon.line(-0.9F, 0.6F, 0.9F, -0.6F);
    else if (name == "Walls")
        icon.path({{-1, 0.7F}, {-0.4F, -0.6F}, {0.3F, 0.4F}, {1, -0.7F}}, false);
    else if (name == "Arc") {
        icon.list.PathArcTo(icon.at(-0.7F, 0.8F), 1.6F * icon.unit, -pi / 2, 0);
        icon.list.PathStroke(icon.color, ImDrawFlags_None, 2);
    } else if (name == "Circle")
        icon.ring(0, 0, 0.8F);
    else if (name == "Polygon")
        icon.path({{0, -0.9F}, {0.9F, -0.2F}, {0.55F, 0.8F}, {-0.55F, 0.8F}, {-0.9F, -0.2F}}, true);
    else if (name == "Capsule")
        icon.list.AddRect(icon.at(-1.1F, -0.4F), icon.at(1.1F, 0.4F), icon.color, 0.4F * icon.unit, 0, 2);
    else if (name == "Point")
        icon.disc(0, 0, 0.3F);
    else if (name == "Flipper") {
        icon.path({{-0.9F, -0.75F}, {0.9F, 0.35F}, {0.75F, 0.75F}, {-1, 0}}, true);
        icon.disc(-0.75F, -0.35F, 0.18F);
    } else if (name == "Gate") {
        icon.line(-0.9F, 0.3F, 0.9F, 0.3F, 1);
        icon.line(0, 0.9F, 0, -0.4F);
        icon.head(0, -0.5F, 0, -0.9F);
    } else if (name == "Lane")
        icon.dashes(-0.9F, 0, 0.9F, 0);
    else if (name == "Spot") {
        for (int i = 0; i < 8; ++i) {
            const float from = static_cast<float>(i) * pi / 4;
            icon.list.PathArcTo(icon.middle, 0.8F * icon.unit, from, from + 0.45F);
            icon.list.PathStroke(icon.color, ImDrawFlags_None, 2);
        }
    } else if (name == "Ball") {
        icon.disc(0, 0, 0.7F);
    } else {
        icon.ring(0, 0.45F, 0.4F);
        icon.line(0, 0.05F, 0, -0.5F);
        icon.head(0, -0.6F, 0, -0.9F);
    }
}

}  // namespace

bool tool_button(const lab::Tool& tool, bool taken, float width) {
    const float size = ImGui::GetFontSize();
    const std::string name(tool.name);
    const ImVec2 corner = ImGui::GetCursorScreenPos(), extent{width, 2.9F * size};
    ImGui::PushStyleColor(ImGuiCol_Button,
                          ImGui::GetStyleColorVec4(taken ? ImGuiCol_ButtonActive : ImGuiCol_Button));
    const bool pressed = ImGui::Button(("##" + name).c_str(), extent);
    ImGui::PopStyleColor();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImU32 color = ImGui::GetColorU32(imgui_color(taken ? colour::lit : colour::text));
    draw_icon({list, {corner.x + 0.5F * width, corner.y + 1.05F * size}, 0.62F * size, color}, tool.name);
    const float letters = ImGui::CalcTextSize(name.c_str()).x;
    list.AddText({corner.x + 0.5F * (width - letters), corner.y + 1.8F * size}, color, name.c_str());
    return pressed;
}

}  // namespace flipside::app

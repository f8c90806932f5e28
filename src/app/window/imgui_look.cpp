#include "app/window/imgui_look.hpp"

#include <algorithm>
#include <cstddef>

#include <imgui.h>

#include "app/window/theme.hpp"

namespace flipside::app {

namespace {

ImVec4 color(sf::Color c, float alpha = 1) {
    return {static_cast<float>(c.r) / 255, static_cast<float>(c.g) / 255, static_cast<float>(c.b) / 255,
            alpha};
}

/// The letters that there are: Latin, Greek and Cyrillic ones, dashes, powers, arrows, signs of formulas. In
/// pairs, first and last.
constexpr ImWchar lettered[] = {0x20,   0x17f,  0x391,  0x3c9,  0x401,  0x451,  0x2013,
                                0x2026, 0x2070, 0x207f, 0x2190, 0x2193, 0x2212, 0x2212,
                                0x221a, 0x221a, 0x2260, 0x2265, 0};

void set_style(double scale) {
    ImGuiStyle& style = ImGui::GetStyle();
    style = {};
    ImGui::StyleColorsDark();
    style.WindowPadding = {12, 10};
    style.FramePadding = {7, 3};
    style.ItemSpacing = {8, 5};
    style.CellPadding = {4, 2};
    style.WindowRounding = style.WindowBorderSize = 0;
    style.FrameRounding = style.GrabRounding = style.PopupRounding = 4;
    style.ScrollbarSize = 10;
    style.ScaleAllSizes(static_cast<float>(scale));
    const sf::Color frame(0x2a, 0x30, 0x39), hovered(0x38, 0x40, 0x4c), active(0x48, 0x52, 0x61);
    const auto set = [&](ImGuiCol which, sf::Color c) { style.Colors[which] = color(c); };
    set(ImGuiCol_Text, colour::text);
    set(ImGuiCol_TextDisabled, colour::quiet);
    set(ImGuiCol_WindowBg, colour::raised);
    set(ImGuiCol_PopupBg, colour::table);
    set(ImGuiCol_Border, colour::rule);
    set(ImGuiCol_Separator, colour::rule);
    set(ImGuiCol_FrameBg, frame);
    set(ImGuiCol_FrameBgHovered, hovered);
    set(ImGuiCol_FrameBgActive, active);
    set(ImGuiCol_Button, frame);
    set(ImGuiCol_ButtonHovered, hovered);
    set(ImGuiCol_ButtonActive, active);
    set(ImGuiCol_Header, colour::table);
    set(ImGuiCol_HeaderHovered, hovered);
    set(ImGuiCol_HeaderActive, active);
    set(ImGuiCol_Tab, colour::table);
    set(ImGuiCol_TabHovered, hovered);
    set(ImGuiCol_TabActive, active);
    set(ImGuiCol_TabUnfocused, colour::table);
    set(ImGuiCol_TabUnfocusedActive, active);
    set(ImGuiCol_CheckMark, colour::text);
    set(ImGuiCol_SliderGrab, {0x55, 0x5f, 0x6d});
    set(ImGuiCol_SliderGrabActive, {0x6c, 0x78, 0x88});
    set(ImGuiCol_ScrollbarBg, colour::raised);
    set(ImGuiCol_ScrollbarGrab, hovered);
    set(ImGuiCol_PlotHistogram, colour::quiet);
    set(ImGuiCol_NavHighlight, colour::lit);
}

/// Gives every figure the width of the widest, so that changing numbers stand still.
void make_figures_tabular(ImFont& font) {
    float widest = 0;
    for (ImWchar digit = '0'; digit <= '9'; ++digit)
        widest = std::max(widest, font.FindGlyph(digit)->AdvanceX);
    for (ImFontGlyph& glyph : font.Glyphs) {
        if (glyph.Codepoint < '0' || glyph.Codepoint > '9') continue;
        const float shift = 0.5F * (widest - glyph.AdvanceX);
        glyph.X0 += shift;
        glyph.X1 += shift;
        glyph.AdvanceX = widest;
    }
    font.BuildLookupTable();
}

void load_fonts(double scale) {
    ImGuiIO& io = ImGui::GetIO();
    io.Fonts->Clear();
    const FontFiles files = find_fonts();
    const auto add = [&](const std::filesystem::path& file, double size) {
        return io.Fonts->AddFontFromFileTTF(file.c_str(), static_cast<float>(scale * size), nullptr,
                                            lettered);
    };
    // ImGui's size is the height of a line, SFML's the size of the letters.
    ImFont* small = add(files.regular, 1.17 * small_type);
    ImFont* large = add(files.strong, 1.17 * large_type);
    io.Fonts->Build();
    for (ImFont* font : {small, large}) make_figures_tabular(*font);
}

}  // namespace

bool is_lettered(std::uint32_t code_point) {
    for (std::size_t i = 0; lettered[i] != 0; i += 2)
        if (code_point >= lettered[i] && code_point <= lettered[i + 1]) return true;
    return false;
}

void set_imgui_look(double scale) {
    set_style(scale);
    load_fonts(scale);
}

}  // namespace flipside::app

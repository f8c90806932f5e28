#include "app/window/imgui_sfml.hpp"

#include <algorithm>

#include <backends/imgui_impl_opengl2.h>

#include "app/window/theme.hpp"

namespace flipside::app {

namespace {

ImVec4 color(sf::Color c, float alpha = 1) {
    return {static_cast<float>(c.r) / 255, static_cast<float>(c.g) / 255, static_cast<float>(c.b) / 255,
            alpha};
}

void set_style(double scale) {
    ImGui::StyleColorsDark();
    ImGuiStyle& style = ImGui::GetStyle();
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
    static constexpr ImWchar ranges[] = {0x20,   0xff,   0x2013, 0x2026, 0x2190, 0x2193, 0x2212,
                                         0x2212, 0x207f, 0x207f, 0x221a, 0x221a, 0};
    ImGuiIO& io = ImGui::GetIO();
    const FontFiles files = find_fonts();
    const auto add = [&](const std::filesystem::path& file, double size) {
        return io.Fonts->AddFontFromFileTTF(file.c_str(), static_cast<float>(scale * size), nullptr, ranges);
    };
    // ImGui's size is the height of a line, SFML's the size of the letters.
    ImFont* small = add(files.regular, 1.17 * small_type);
    ImFont* large = add(files.strong, 1.17 * large_type);
    io.Fonts->Build();
    for (ImFont* font : {small, large}) make_figures_tabular(*font);
}

void map_keys() {
    static constexpr std::pair<ImGuiKey, sf::Keyboard::Key> keys[] = {
        {ImGuiKey_Backspace, sf::Keyboard::BackSpace}, {ImGuiKey_Delete, sf::Keyboard::Delete},
        {ImGuiKey_Enter, sf::Keyboard::Enter},         {ImGuiKey_Escape, sf::Keyboard::Escape},
        {ImGuiKey_LeftArrow, sf::Keyboard::Left},      {ImGuiKey_RightArrow, sf::Keyboard::Right},
        {ImGuiKey_Home, sf::Keyboard::Home},           {ImGuiKey_End, sf::Keyboard::End}};
    for (const auto& [ours, theirs] : keys) ImGui::GetIO().KeyMap[ours] = theirs;
}

/// Tells ImGui of a move or a button. Whether a button changed.
bool take_mouse(const sf::Event& event) {
    ImGuiIO& io = ImGui::GetIO();
    if (event.type == sf::Event::MouseMoved) {
        io.MousePos = {static_cast<float>(event.mouseMove.x), static_cast<float>(event.mouseMove.y)};
        return false;
    }
    io.MousePos = {static_cast<float>(event.mouseButton.x), static_cast<float>(event.mouseButton.y)};
    io.MouseDown[event.mouseButton.button] = event.type == sf::Event::MouseButtonPressed;
    return true;
}

}  // namespace

Imgui::Imgui(sf::RenderWindow& window, double scale) : window_(window) {
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;
    set_style(scale);
    load_fonts(scale);
    map_keys();
    ImGui_ImplOpenGL2_Init();
}

Imgui::~Imgui() {
    ImGui_ImplOpenGL2_Shutdown();
    ImGui::DestroyContext();
}

void Imgui::process(const sf::Event& event) {
    ImGuiIO& io = ImGui::GetIO();
    switch (event.type) {
        case sf::Event::MouseMoved:
        case sf::Event::MouseButtonPressed:
        case sf::Event::MouseButtonReleased:
            mouse_.push_back(event);
            break;
        case sf::Event::LostFocus:
            mouse_.clear();
            std::ranges::fill(io.MouseDown, false);
            break;
        case sf::Event::MouseWheelScrolled:
            io.MouseWheel += event.mouseWheelScroll.delta;
            break;
        case sf::Event::KeyPressed:
        case sf::Event::KeyReleased:
            if (event.key.code >= 0) io.KeysDown[event.key.code] = event.type == sf::Event::KeyPressed;
            io.KeyCtrl = event.key.control;
            io.KeyShift = event.key.shift;
            break;
        case sf::Event::TextEntered:
            if (event.text.unicode >= ' ' && event.text.unicode != 127)
                io.AddInputCharacter(event.text.unicode);
            break;
        default:
            break;
    }
}

void Imgui::begin_frame(double seconds) {
    ImGuiIO& io = ImGui::GetIO();
    const sf::Vector2f size(window_.getSize());
    io.DisplaySize = {size.x, size.y};
    io.DeltaTime = std::max(1e-4F, static_cast<float>(seconds));
    // One change of a button in a frame, where it happened: what is pressed and let go between two frames is
    // a click too, and where the mouse is by then does not matter.
    for (bool changed = false; !changed && !mouse_.empty(); mouse_.pop_front())
        changed = take_mouse(mouse_.front());
    ImGui_ImplOpenGL2_NewFrame();
    ImGui::NewFrame();
}

void Imgui::end_frame() {
    ImGui::Render();
    window_.pushGLStates();
    ImGui_ImplOpenGL2_RenderDrawData(ImGui::GetDrawData());
    window_.popGLStates();
}

}  // namespace flipside::app

#include "app/window/imgui_sfml.hpp"

#include <algorithm>
#include <utility>

#include <backends/imgui_impl_opengl2.h>

#include "app/window/imgui_look.hpp"

namespace flipside::app {

namespace {

void map_keys() {
    using K = sf::Keyboard;
    static constexpr std::pair<ImGuiKey, K::Key> keys[] = {{ImGuiKey_Tab, K::Tab},
                                                           {ImGuiKey_Backspace, K::BackSpace},
                                                           {ImGuiKey_Delete, K::Delete},
                                                           {ImGuiKey_Enter, K::Enter},
                                                           {ImGuiKey_Escape, K::Escape},
                                                           {ImGuiKey_Space, K::Space},
                                                           {ImGuiKey_LeftArrow, K::Left},
                                                           {ImGuiKey_RightArrow, K::Right},
                                                           {ImGuiKey_UpArrow, K::Up},
                                                           {ImGuiKey_DownArrow, K::Down},
                                                           {ImGuiKey_Home, K::Home},
                                                           {ImGuiKey_End, K::End},
                                                           {ImGuiKey_PageUp, K::PageUp},
                                                           {ImGuiKey_PageDown, K::PageDown},
                                                           {ImGuiKey_A, K::A},
                                                           {ImGuiKey_C, K::C},
                                                           {ImGuiKey_V, K::V},
                                                           {ImGuiKey_X, K::X},
                                                           {ImGuiKey_Y, K::Y},
                                                           {ImGuiKey_Z, K::Z}};
    for (const auto& [ours, theirs] : keys) ImGui::GetIO().KeyMap[ours] = theirs;
}

bool is_button(const sf::Event& event) {
    return event.type == sf::Event::MouseButtonPressed || event.type == sf::Event::MouseButtonReleased;
}

bool is_function_key(sf::Keyboard::Key key) {
    return key >= sf::Keyboard::F1 && key <= sf::Keyboard::F15;
}

/// Whether what has the keyboard may be another thing after it.
bool moves_focus(const sf::Event& event) {
    if (event.type == sf::Event::MouseButtonPressed) return true;
    if (event.type != sf::Event::KeyPressed) return false;
    const sf::Keyboard::Key key = event.key.code;
    return key == sf::Keyboard::Enter || key == sf::Keyboard::Tab || key == sf::Keyboard::Escape;
}

/// Whether ImGui needs a frame of its own before it: to ImGui, two changes of one button or key in a frame
/// are none, a slider is not moved in the frame in which the button is let go, and a tab is not pressed in
/// the frame in which the pointer came to it from another one. Escape closes what is open once the keys
/// before it have been acted on.
bool ends_frame(const sf::Event& event, const std::vector<sf::Event>& taken) {
    if (taken.empty()) return false;
    if (event.type == sf::Event::KeyPressed && event.key.code == sf::Keyboard::Escape) return true;
    if (is_button(taken.back()) || moves_focus(taken.back())) return true;
    if (is_button(event) && taken.back().type == sf::Event::MouseMoved) return true;
    return event.type == sf::Event::KeyReleased && std::ranges::any_of(taken, [&](const sf::Event& other) {
               return other.type == sf::Event::KeyPressed && other.key.code == event.key.code;
           });
}

void take_key(const sf::Event& event, bool tab) {
    ImGuiIO& io = ImGui::GetIO();
    const bool down = event.type == sf::Event::KeyPressed;
    // ImGui would go to the next field by Tab at any time.
    if (event.key.code >= 0 && (event.key.code != sf::Keyboard::Tab || tab || !down))
        io.KeysDown[event.key.code] = down;
    // What an event of Ctrl or Shift says of them is how they were before it.
    const auto held = [&](sf::Keyboard::Key left, sf::Keyboard::Key right, bool before) {
        const bool own = event.key.code == left || event.key.code == right;
        return own ? io.KeysDown[left] || io.KeysDown[right] : before;
    };
    io.KeyCtrl = held(sf::Keyboard::LControl, sf::Keyboard::RControl, event.key.control);
    io.KeyShift = held(sf::Keyboard::LShift, sf::Keyboard::RShift, event.key.shift);
}

/// `tab`: it is for ImGui too.
void take(const sf::Event& event, bool tab) {
    ImGuiIO& io = ImGui::GetIO();
    switch (event.type) {
        case sf::Event::MouseMoved:
            io.MousePos = {static_cast<float>(event.mouseMove.x), static_cast<float>(event.mouseMove.y)};
            break;
        case sf::Event::MouseButtonPressed:
        case sf::Event::MouseButtonReleased:
            io.MousePos = {static_cast<float>(event.mouseButton.x), static_cast<float>(event.mouseButton.y)};
            io.MouseDown[event.mouseButton.button] = event.type == sf::Event::MouseButtonPressed;
            break;
        case sf::Event::LostFocus:
            std::ranges::fill(io.MouseDown, false);
            std::ranges::fill(io.KeysDown, false);
            io.KeyCtrl = io.KeyShift = false;
            break;
        case sf::Event::MouseWheelScrolled:
            io.MouseWheel += event.mouseWheelScroll.delta;
            break;
        case sf::Event::KeyPressed:
        case sf::Event::KeyReleased:
            take_key(event, tab);
            break;
        case sf::Event::TextEntered:
            if (event.text.unicode >= ' ' && event.text.unicode != 127)
                io.AddInputCharacter(event.text.unicode);
            break;
        default:
            break;
    }
}

}  // namespace

Imgui::Imgui(sf::RenderWindow& window, double scale) : window_(window) {
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;
    set_imgui_look(scale);
    map_keys();
    ImGui_ImplOpenGL2_Init();
}

Imgui::~Imgui() {
    ImGui_ImplOpenGL2_Shutdown();
    ImGui::DestroyContext();
}

void Imgui::set_scale(double scale) {
    set_imgui_look(scale);
    ImGui_ImplOpenGL2_DestroyFontsTexture();
    ImGui_ImplOpenGL2_CreateFontsTexture();
}

std::vector<sf::Event> Imgui::begin_frame(double seconds) {
    ImGuiIO& io = ImGui::GetIO();
    const sf::Vector2f size(window_.getSize());
    io.DisplaySize = {size.x, size.y};
    io.DeltaTime = std::max(1e-4F, static_cast<float>(seconds));
    std::vector<sf::Event> taken;
    // ImGui says a frame later that a field has closed.
    if (!std::exchange(focus_moves_, false))
        for (; !waiting_.empty() && !ends_frame(waiting_.front(), taken); waiting_.pop_front()) {
            taken.push_back(waiting_.front());
            take(waiting_.front(), keys_wanted_ || io.WantTextInput);
        }
    focus_moves_ = !taken.empty() && moves_focus(taken.back());
    const bool closes = ImGui::IsAnyItemActive() || ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup);
    ImGui_ImplOpenGL2_NewFrame();
    ImGui::NewFrame();
    std::erase_if(taken, [&](const sf::Event& event) {
        if (event.type == sf::Event::MouseButtonPressed || event.type == sf::Event::MouseWheelScrolled ||
            event.type == sf::Event::MouseMoved)
            return io.WantCaptureMouse;
        if (event.type != sf::Event::KeyPressed || is_function_key(event.key.code)) return false;
        if (event.key.code == sf::Keyboard::Escape && keys_wanted_ && !closes) return false;
        return keys_wanted_ || io.WantTextInput;
    });
    return taken;
}

void Imgui::want_keys(bool wanted) {
    if (wanted == keys_wanted_) return;
    keys_wanted_ = wanted;
    int& flags = ImGui::GetIO().ConfigFlags;
    flags = wanted ? flags | ImGuiConfigFlags_NavEnableKeyboard : flags & ~ImGuiConfigFlags_NavEnableKeyboard;
    if (!wanted) ImGui::SetWindowFocus(nullptr);
}

void Imgui::end_frame() {
    ImGui::Render();
    window_.pushGLStates();
    ImGui_ImplOpenGL2_RenderDrawData(ImGui::GetDrawData());
    window_.popGLStates();
}

}  // namespace flipside::app

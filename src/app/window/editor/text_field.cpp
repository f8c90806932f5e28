#include "app/window/editor/text_field.hpp"

#include <algorithm>
#include <vector>

#include <imgui.h>

namespace flipside::app {

bool text_field(const char* id, std::string& text, std::size_t most, bool on_enter) {
    std::vector<char> letters(most + 1);
    std::copy_n(text.begin(), std::min(text.size(), most), letters.begin());
    const bool changed = ImGui::InputText(
        id, letters.data(), letters.size(),
        ImGuiInputTextFlags_AutoSelectAll | (on_enter ? ImGuiInputTextFlags_EnterReturnsTrue : 0));
    text = letters.data();
    return changed;
}

}  // namespace flipside::app

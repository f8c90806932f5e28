#include "app/window/browser/scene_browser.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/window/browser/thumbnail.hpp"
#include "app/window/panel_parts.hpp"
#include "lab/files/assets.hpp"
#include "world/input_error.hpp"
#include "world/json_file.hpp"
#include "world/printable.hpp"
#include "world/scene_file.hpp"

namespace flipside::app {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t most_cards = 300, most_pictured = 50'000;
constexpr std::uintmax_t largest_file = 4U << 20U;  ///< bytes, of what may be a scene
constexpr double card_width = 290, card_height = 310, picture_height = 196;  ///< px on an ordinary display

/// Scenes in a folder by their ending and what they begin with: other JSON files are none.
std::vector<fs::path> scenes_in(const fs::path& folder) {
    std::vector<fs::path> files;
    std::error_code failed;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, failed)) {
        std::error_code unknown;
        if (files.size() == most_cards || entry.path().extension() != ".json" ||
            !entry.is_regular_file(unknown))
            continue;
        try {
            if (read_file(entry.path(), largest_file).find("\"flipside-scene/1\"") != std::string::npos)
                files.push_back(entry.path());
        } catch (const InputError&) {
            continue;  // it cannot be read, so it is not known to be a scene
        }
    }
    std::ranges::sort(files);
    return files;
}

/// Broken between words. As many lines as fit above `bottom`, px; what does not ends in an ellipsis.
void write_lines(ImDrawList& list, ImVec2 at, float room, float bottom, const std::string& words,
                 ImU32 color) {
    const float height = ImGui::GetFontSize();
    const auto most = static_cast<std::size_t>(std::max(0.0F, (bottom - at.y) / height));
    for (const std::string& line : lines_of(words, room, most)) {
        list.AddText(at, color, line.c_str());
        at.y += height;
    }
}

}  // namespace

void SceneBrowser::open(const std::string& current) {
    open_ = true;
    warning_.clear();
    chosen_.reset();
    list(current);
}

void SceneBrowser::list(const std::string& current) {
    cards_.clear();
    marked_ = 0;
    follow_ = true;
    const auto add = [&](std::string scene, fs::path file) {
        if (scene == current) marked_ = cards_.size();
        Card card;
        card.scene = std::move(scene);
        card.file = std::move(file);
        cards_.push_back(std::move(card));
    };
    const std::vector<std::string> names = lab::scene_names();
    for (const std::string& name : names) add(name, lab::scene_file(name));
    const bool known = current.empty() || std::ranges::find(names, current) != names.end();
    std::error_code unknown;
    const fs::path folder = known ? fs::current_path(unknown) : fs::absolute(current, unknown).parent_path();
    for (const fs::path& file : scenes_in(folder)) {
        const bool listed = std::ranges::any_of(
            cards_, [&](const Card& card) { return fs::equivalent(card.file, file, unknown); });
        if (!listed) add(file.string(), file);
    }
}

void SceneBrowser::read_one(const Lettering& lettering) {
    const auto next = std::ranges::find(cards_, false, &Card::read);
    if (next != cards_.end()) read(*next, lettering);
}

void SceneBrowser::read(Card& card, const Lettering& lettering) {
    card.read = true;
    card.name = card.file.stem().string();
    try {
        const std::string text = read_file(card.file);
        const auto scene = std::make_shared<const Scene>(parse_scene(text, card.file.string()));
        if (!scene->name.empty()) card.name = scene->name;
        card.about = scene->about;
        std::shared_ptr<const sf::Texture>& picture = pictures_[text];
        if (!picture && scene->parts.size() + scene->balls.size() <= most_pictured)
            picture =
                thumbnail_of(scene, lettering, static_cast<unsigned>(lettering.scale() * (card_width - 16)),
                             static_cast<unsigned>(lettering.scale() * picture_height));
        card.picture = picture;
    } catch (const std::exception& error) {
        card.fault = error.what();
    }
}

bool SceneBrowser::process(const sf::Event& event) {
    if (event.type != sf::Event::KeyPressed) return event.type != sf::Event::KeyReleased;
    if (cards_.empty()) return false;
    const auto go = [&](std::ptrdiff_t by) {
        const auto last = static_cast<std::ptrdiff_t>(cards_.size()) - 1;
        marked_ = static_cast<std::size_t>(
            std::clamp(static_cast<std::ptrdiff_t>(marked_) + by, std::ptrdiff_t{0}, last));
        follow_ = true;
    };
    const auto row = static_cast<std::ptrdiff_t>(columns_);
    using Key = sf::Keyboard;
    switch (event.key.code) {
        case Key::Left:
            go(-1);
            break;
        case Key::Right:
            go(1);
            break;
        case Key::Up:
            go(-row);
            break;
        case Key::Down:
            go(row);
            break;
        case Key::Enter:
            chosen_ = marked_;
            break;
        case Key::Escape:
        case Key::F3:
            close();
            break;
        default:
            return event.key.code != Key::F12;
    }
    return true;
}

bool SceneBrowser::draw_card(std::size_t i, double width, double height, ControlPlaces& places) {
    const Card& card = cards_[i];
    const float size = ImGui::GetFontSize(), pad = 0.55F * size;
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const bool pressed =
        ImGui::InvisibleButton(("##card" + std::to_string(i)).c_str(), imgui_vector(width, height));
    if (ImGui::IsItemHovered() && (ImGui::GetIO().MouseDelta.x != 0 || ImGui::GetIO().MouseDelta.y != 0))
        marked_ = i;
    if (marked_ == i && std::exchange(follow_, false)) ImGui::SetScrollHereY(0.5F);
    note(places, "scene card " + card.scene);
    const ImVec2 end{corner.x + static_cast<float>(width), corner.y + static_cast<float>(height)};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(corner, end, ImGui::GetColorU32(imgui_color(colour::raised)), 0.3F * size);
    if (marked_ == i)
        list.AddRect(corner, end, ImGui::GetColorU32(imgui_color(colour::lit)), 0.3F * size, 0, 2);
    float y = corner.y + pad;
    if (card.picture) {
        const sf::Vector2f pixels(card.picture->getSize());
        const float left = corner.x + 0.5F * (static_cast<float>(width) - pixels.x);
        const auto handle = static_cast<std::uintptr_t>(card.picture->getNativeHandle());
        list.AddImage(reinterpret_cast<ImTextureID>(handle), {left, y}, {left + pixels.x, y + pixels.y});
        y += pixels.y + 0.5F * pad;
    }
    const float room = static_cast<float>(width) - 2 * pad;
    const std::string name = cut(printable(card.read ? card.name : card.file.stem().string()), room);
    list.AddText({corner.x + pad, y}, ImGui::GetColorU32(ImGuiCol_Text), name.c_str());
    y += 1.2F * size;
    const std::string words = printable(card.fault.empty() ? card.about : card.fault);
    const ImU32 color = ImGui::GetColorU32(
        card.fault.empty() ? ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled) : imgui_color(colour::warning));
    write_lines(list, {corner.x + pad, y}, room, end.y - 0.3F * pad, words, color);
    tooltip(words);
    return pressed;
}

void SceneBrowser::draw_cards(ControlPlaces& places) {
    const double scale = ImGui::GetFontSize() / (1.17 * small_type);
    const double gap = 10 * scale, room = ImGui::GetContentRegionAvail().x;
    columns_ = std::max<std::size_t>(1, static_cast<std::size_t>((room + gap) / (card_width * scale + gap)));
    const auto columns = static_cast<double>(columns_);
    const double width =
        std::min(1.4 * card_width * scale, std::floor((room - gap * (columns - 1)) / columns));
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, imgui_vector(gap, gap));
    for (std::size_t i = 0; i < cards_.size(); ++i) {
        if (i % columns_ != 0) ImGui::SameLine();
        if (draw_card(i, width, card_height * scale, places)) chosen_ = marked_ = i;
    }
    ImGui::PopStyleVar();
}

std::optional<std::string> SceneBrowser::draw(const Rect& window, const Lettering& lettering,
                                              ControlPlaces& places) {
    read_one(lettering);
    ImGui::SetNextWindowPos(imgui_vector(window.x, window.y));
    ImGui::SetNextWindowSize(imgui_vector(window.width, window.height));
    ImGui::SetNextWindowFocus();
    ImGui::PushStyleColor(ImGuiCol_WindowBg, imgui_color(colour::around));
    ImGui::Begin("scenes", nullptr, docked & ~ImGuiWindowFlags_NoScrollbar);
    ImGui::PushFont(ImGui::GetIO().Fonts->Fonts[1]);
    ImGui::TextUnformatted("Scenes");
    ImGui::PopFont();
    ImGui::SameLine();
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("Arrows and Enter, or a click, open one; Esc goes back");
    ImGui::SameLine(ImGui::GetContentRegionMax().x - 4 * ImGui::GetFontSize());
    if (ImGui::Button("Back")) close();
    note(places, "Back");
    if (!warning_.empty()) wrapped(printable(warning_), colour::warning);
    ImGui::BeginChild("cards", {0, 0}, false);
    draw_cards(places);
    ImGui::EndChild();
    ImGui::End();
    ImGui::PopStyleColor();
    const auto chosen = std::exchange(chosen_, std::nullopt);
    if (!chosen || !cards_[*chosen].fault.empty()) return std::nullopt;
    return cards_[*chosen].scene;
}

}  // namespace flipside::app

#include "app/window/kept.hpp"

#include <algorithm>
#include <cstdlib>

#include <nlohmann/json.hpp>

#include "lab/files/assets.hpp"
#include "lab/files/whole_file.hpp"
#include "lab/process/failure.hpp"
#include "world/input_error.hpp"
#include "world/json_file.hpp"
#include "world/schema.hpp"

namespace flipside::app {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view format = "flipside-window/1";
constexpr std::uintmax_t largest_file = 1U << 16U;

std::string text_of(const Kept& kept) {
    nlohmann::ordered_json j;
    j["format"] = format;
    j["width"] = kept.width;
    j["height"] = kept.height;
    j["scale"] = kept.scale;
    j["scene"] = kept.scene;
    if (!kept.lesson.empty()) j["lesson"] = kept.lesson;
    j["view"] = view_name(kept.view);
    j["contenders"] = kept.contenders;
    j["show"] = nlohmann::ordered_json::array();
    for (std::size_t i = 0; i < show_count; ++i)
        if (kept.look.shows[i]) j["show"].push_back(show_specs[i].name);
    j["random_colours"] = kept.look.random_colours;
    j["artwork"] = kept.look.artwork;
    j["panel_open"] = kept.panel_open;
    j["plots"] = spec_of(kept.plots).name;
    j["strip"] = kept.strip;
    j["muted"] = kept.muted;
    return json_text(j, 2) + '\n';
}

/// An absolute path in a variable; the specification has others ignored.
fs::path folder_in(const char* variable) {
    const char* value = std::getenv(variable);
    const fs::path folder = value == nullptr ? "" : value;
    return folder.is_absolute() ? folder : fs::path();
}

}  // namespace

std::optional<fs::path> kept_file() {
    fs::path folder = folder_in("XDG_STATE_HOME");
    if (folder.empty()) {
        const fs::path home = folder_in("HOME");
        if (home.empty()) return std::nullopt;
        folder = home / ".local" / "state";
    }
    return folder / "flipside" / "window.json";
}

Kept load_kept(const fs::path& file) {
    const std::string name = file.string();
    const Json document = parse_json(read_file(file, largest_file), name);
    check_form(document, window_schema, name);
    const Node node(document, name);
    Kept kept;
    kept.width = static_cast<unsigned>(node.integer("width"));
    kept.height = static_cast<unsigned>(node.integer("height"));
    kept.scale = node.real("scale");
    kept.scene = node.text("scene");
    kept.lesson = node.text("lesson");
    for (const View view : {View::single, View::split, View::overlay})
        if (node.text("view") == view_name(view)) kept.view = view;
    for (const Node& contender : node.each("contenders"))
        kept.contenders.push_back(contender.json().get<std::string>());
    kept.look.shows.reset();
    for (const Node& shown : node.each("show"))
        for (std::size_t i = 0; i < show_count; ++i)
            if (shown.json() == show_specs[i].name) kept.look.shows.set(i);
    kept.look.random_colours = node.toggle("random_colours");
    if (node.has("artwork")) kept.look.artwork = node.toggle("artwork");
    kept.panel_open = node.toggle("panel_open");
    if (node.has("plots")) kept.plots = plots_named(node.text("plots"));
    kept.strip = node.real("strip", kept.strip);
    if (node.has("muted")) kept.muted = node.toggle("muted");
    return kept;
}

std::string kept_name(const std::string& scene) {
    const auto names = lab::scene_names();
    return std::ranges::find(names, scene) != names.end() ? scene : absolute(lab::scene_file(scene)).string();
}

Keeper::Keeper(fs::path file) : file_(std::move(file)) {
    std::error_code why;
    first_start_ = !fs::exists(file_, why) && !why;
    if (first_start_) return;
    try {
        found_ = last_ = load_kept(file_);
    } catch (const InputError& error) {
        writable_ = false;
        trouble_ = "what was kept of the last start is left alone: " + std::string(error.what());
    }
}

std::string Keeper::keep(const Kept& kept) {
    if (!writable_ || kept == last_) return "";
    try {
        lab::make_folder(file_.parent_path());
        lab::write_whole_file(file_, text_of(kept));
        last_ = kept;
    } catch (const std::runtime_error& error) {
        writable_ = false;
        return "nothing is kept for the next start: " + std::string(error.what());
    }
    return "";
}

}  // namespace flipside::app

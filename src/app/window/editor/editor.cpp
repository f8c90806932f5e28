#include "app/window/editor/editor.hpp"

#include <algorithm>
#include <numbers>

#include "lab/files/assets.hpp"
#include "lab/files/whole_file.hpp"
#include "lab/session/pick.hpp"
#include "world/input_error.hpp"
#include "world/json_file.hpp"

namespace flipside::app {

namespace {

constexpr double turn_arm = 46;     ///< px from the middle to where it is turned
constexpr double turn_beyond = 14;  ///< and beyond the farthest place of the thing
constexpr double handle_reach = 8;  ///< px
constexpr double item_reach = 6;    ///< px
constexpr double handle_room = 14;  ///< px, between handles
constexpr double join_reach = 10;   ///< px, of ends

}  // namespace

void Editor::show(lab::Draft draft) {
    draft_ = std::move(draft);
    saved_ = draft_->document().text();
    selection_.clear();
    tool_ = 0;
    pen_.clear();
    drag_.reset();
    on_ = true;
    pitch = lab::usual_pitch(draft_->scene()->bounds.max.x - draft_->scene()->bounds.min.x);
}

void Editor::begin(const Stage& stage) {
    const bool as_it_was = unsaved() || (draft_ && (own_ ? !file_changed() : name_.empty()));
    if (as_it_was && name_ == stage.scene_name()) {
        on_ = true;
        return;
    }
    if (stage.is_from_file()) return begin_file(stage.scene_name());
    show(lab::Draft(lab::laid_out(lab::OrderedJson::parse(*stage.scene().document)), stage.scene_name()));
    name_ = stage.scene_name();
    own_.reset();
}

void Editor::begin_new() {
    show(lab::Draft(lab::new_scene(), "the new scene"));
    name_.clear();
    own_.reset();
}

void Editor::begin_file(const std::string& name) {
    const std::filesystem::path file = lab::scene_file(name);
    std::string text = read_file(file);
    show(lab::Draft(text, file.string()));
    name_ = name;
    own_ = lab::OwnFile{file, std::move(text)};
}

bool Editor::unsaved() const {
    return draft_ && draft_->document().text() != saved_;
}

bool Editor::file_changed() const {
    return own_ && lab::obstacle_to(own_->file, own_) == lab::SaveObstacle::changed;
}

void Editor::save_to(const std::filesystem::path& file) {
    const std::string& text = draft_->document().text();
    lab::write_whole_file(file, text);
    saved_ = text;
    // A shipped scene keeps its short name.
    if (!own_ || own_->file != file) name_ = std::filesystem::absolute(file).string();
    own_ = lab::OwnFile{file, text};
}

std::vector<lab::Handle> Editor::handles(const Camera& camera, double scale) const {
    const lab::OrderedJson* thing = draft_->find(selected());
    if (thing == nullptr || draws() || selection_.size() > 1) return {};
    std::vector<lab::Handle> handles = lab::handles_of(*thing);
    const std::vector<lab::Handle> all = handles;
    // What is small on the screen is moved and not changed; zooming in brings its handles.
    std::erase_if(handles, [&](const lab::Handle& handle) {
        if (handle.role == lab::Role::radius && handle.anchor)
            return camera.scale * length(handle.at - *handle.anchor) < scale * handle_room;
        return handle.role == lab::Role::between && std::ranges::any_of(all, [&](const lab::Handle& other) {
                   return other.role == lab::Role::corner &&
                          camera.scale * length(handle.at - other.at) < scale * handle_room;
               });
    });
    return handles;
}

std::optional<Editor::TurnHandle> Editor::turn_handle(const Camera& camera, double scale) const {
    const lab::Item item = selected();
    const lab::OrderedJson* thing = draft_->find(item);
    if (thing == nullptr || draws() || item.kind != lab::Item::Kind::part || selection_.size() > 1)
        return std::nullopt;
    const auto& is = draft_->sketch().parts[item.index].shape.is;
    if (std::holds_alternative<shape::Point>(is) || std::holds_alternative<shape::Circle>(is))
        return std::nullopt;
    const Vec2 about = camera.to_pixels(lab::middle_of(*thing));
    double far = scale * turn_arm;
    for (const lab::Handle& handle : lab::handles_of(*thing))
        far = std::max(far, length(camera.to_pixels(handle.at) - about) + scale * turn_beyond);
    const double reach = std::min(far, scale * 120);
    // Across its direction, where no handle is: not on the side to which a flipper goes.
    const auto* flip = std::get_if<motion::Flip>(&draft_->sketch().parts[item.index].motion);
    const double direction = lab::direction_of(*thing).value_or(0);
    const double side = flip != nullptr && flip->raised > direction ? -0.5 : 0.5;
    const Vec2 way = from_angle(direction + side * std::numbers::pi);
    return TurnHandle{about, about + reach * Vec2{way.x, -way.y}};
}

std::optional<lab::Handle> Editor::handle_at(Vec2 pixel, const Camera& camera, double scale) const {
    std::optional<lab::Handle> nearest;
    double reach = scale * handle_reach;
    // Of several at one place the last is the one to pull.
    for (const lab::Handle& handle : handles(camera, scale)) {
        const double distance = length(camera.to_pixels(handle.at) - pixel);
        if (distance > reach) continue;
        nearest = handle;
        reach = distance;
    }
    return nearest;
}

std::optional<lab::Item> Editor::item_at(Vec2 at, double reach) const {
    const Scene& scene = draft_->sketch();
    const std::vector<PartState> still(scene.parts.size());
    if (const auto found = lab::pick(scene, scene.balls, still, at, reach))
        return lab::Item{found->is_ball ? lab::Item::Kind::ball : lab::Item::Kind::part, found->index};
    if (scene.launcher &&
        length(at - scene.launcher->position) < launcher_radii * scene.launcher->ball.radius + reach)
        return lab::Item{lab::Item::Kind::launcher, 0};
    return std::nullopt;
}

std::vector<Vec2> Editor::ends_but_of(std::span<const lab::Item> items) const {
    std::vector<Vec2> ends;
    const auto add = [&](const lab::Item& other) {
        if (std::ranges::find(items, other) != items.end()) return;
        if (const lab::OrderedJson* thing = draft_->find(other))
            for (const Vec2 joint : lab::joints_of(*thing)) ends.push_back(joint);
    };
    for (std::size_t i = 0; i < draft_->sketch().parts.size(); ++i) add({lab::Item::Kind::part, i});
    add({lab::Item::Kind::bounds, 0});
    return ends;
}

lab::SnapRules Editor::rules(const Pointing& pointing) const {
    return {snaps && !pointing.unsnapped, pitch, pointing.scale * join_reach / pointing.camera.scale};
}

void Editor::take(const lab::Tool& tool) {
    pen_.clear();
    tool_ = static_cast<std::size_t>(&tool - lab::tools().data());
    draft_->end_step();
}

void Editor::undo() {
    drag_.reset();
    if (!pen_.empty()) return pen_.pop_back();
    draft_->undo();
    keep_selection_valid();
}

void Editor::redo() {
    drag_.reset();
    draft_->redo();
    keep_selection_valid();
}

}  // namespace flipside::app

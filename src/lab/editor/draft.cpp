#include "lab/editor/draft.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "lab/editor/rules.hpp"
#include "world/input_error.hpp"
#include "world/scene_file.hpp"

namespace flipside::lab {

namespace {

constexpr std::string_view drawing = "scene";  ///< named in errors, and taken off again

std::optional<Item> item_at(std::string_view pointer) {
    for (const auto& [begin, kind] : {std::pair<std::string_view, Item::Kind>{"/parts/", Item::Kind::part},
                                      {"/balls/", Item::Kind::ball}}) {
        if (!pointer.starts_with(begin)) continue;
        std::size_t index = 0;
        for (const char c : pointer.substr(begin.size())) {
            if (c < '0' || c > '9') break;
            index = 10 * index + static_cast<std::size_t>(c - '0');
        }
        return Item{kind, index};
    }
    if (pointer.starts_with("/launcher")) return Item{Item::Kind::launcher, 0};
    if (pointer.starts_with("/bounds")) return Item{Item::Kind::bounds, 0};
    return std::nullopt;
}

/// From "scene: /json/pointer: words".
Problem problem_of(std::string_view message) {
    message.remove_prefix(std::min(message.size(), drawing.size() + 2));
    const std::size_t colon = message.find(": ");
    if (!message.starts_with('/') || colon == std::string_view::npos) return {std::string(message), {}};
    return {std::string(message.substr(colon + 2)), item_at(message.substr(0, colon))};
}

std::shared_ptr<const Scene> checked(const std::string& text, const std::string& file) {
    return std::make_shared<const Scene>(parse_scene(text, file));
}

}  // namespace

Path path_of(const Item& item) {
    switch (item.kind) {
        case Item::Kind::part:
            return {"parts", std::to_string(item.index)};
        case Item::Kind::ball:
            return {"balls", std::to_string(item.index)};
        case Item::Kind::launcher:
            return {"launcher"};
        default:
            return {"bounds"};
    }
}

Draft::Draft(std::string text, const std::string& file)
    : document_((static_cast<void>(checked(text, file)), std::move(text))) {
    refresh();
}

void Draft::refresh() {
    sketch_ = sketch_of(document_.json());
    problem_.reset();
    try {
        scene_ = checked(document_.text(), std::string(drawing));
    } catch (const InputError& error) {
        problem_ = problem_of(error.what());
    }
}

const OrderedJson* Draft::find(const Item& item) const {
    return lab::find(document_.json(), path_of(item));
}

double Draft::ball_radius() const {
    if (sketch_.launcher) return sketch_.launcher->ball.radius;
    if (!sketch_.balls.empty()) return sketch_.balls.front().radius;
    if (!scene_->balls.empty()) return scene_->balls.front().radius;
    constexpr double of_width = 0.026;  // 13.5 mm on a table of 0.52 m
    const double width = sketch_.bounds.max.x - sketch_.bounds.min.x;
    return std::max(1e-4, std::round(1e4 * of_width * width) / 1e4);
}

void Draft::set(const Path& path, const OrderedJson& value) {
    document_.set(path, value);
    refresh();
}

void Draft::move(std::span<const Item> items, Vec2 by) {
    for (const Item& item : items)
        if (const OrderedJson* thing = find(item)) document_.set(path_of(item), moved(*thing, by));
    refresh();
}

std::string Draft::free_name(const std::string& stem) const {
    std::set<std::string> taken;
    for (const Part& part : sketch_.parts) taken.insert(part.name);
    for (const Part& part : scene_->parts) taken.insert(part.name);
    for (int i = 1;; ++i)
        if (std::string name = stem + "-" + std::to_string(i); !taken.contains(name)) return name;
}

Item Draft::add(const Tool& tool, std::span<const Vec2> points) {
    OrderedJson thing = made(tool, points, free_name(std::string(tool.stem)), ball_radius());
    const std::string place(place_of(tool));
    const auto use = [&](OrderedJson& user, const char* material) {
        if (lab::find(document_.json(), {"materials", material}) != nullptr) user["material"] = material;
    };
    if (place == "launcher") {
        use(thing["ball"], "ball");
        const OrderedJson* before = find({Item::Kind::launcher, 0});
        // A scene has one: it comes to the new place as it is.
        if (before != nullptr) {
            OrderedJson there = *before;
            there["position"] = thing["position"];
            thing = there;
        }
        set({place}, thing);
        return {Item::Kind::launcher, 0};
    }
    if (place == "balls") use(thing, "ball");
    if (place == "parts" && !thing.contains("sensor"))
        use(thing, thing.contains("motion") ? "rubber" : "wall");
    document_.append({place}, thing);
    refresh();
    return place == "balls" ? Item{Item::Kind::ball, sketch_.balls.size() - 1}
                            : Item{Item::Kind::part, sketch_.parts.size() - 1};
}

Item Draft::duplicate(const Item& item, Vec2 by) {
    OrderedJson copy = moved(*find(item), by);
    const std::string place = path_of(item).front();
    if (item.kind == Item::Kind::part) {
        // "wall-3" gives "wall-4", or the next that is free.
        std::string stem = copy.at("name");
        const std::size_t end = stem.find_last_not_of("0123456789");
        if (end != std::string::npos && end > 0 && stem[end] == '-') stem.resize(end);
        copy["name"] = free_name(stem.substr(0, 90));
    }
    document_.append({place}, copy);
    refresh();
    return {item.kind, (item.kind == Item::Kind::ball ? sketch_.balls.size() : sketch_.parts.size()) - 1};
}

void Draft::remove(const Item& item) {
    if (item.kind == Item::Kind::bounds) return;
    if (item.kind == Item::Kind::part) name_in_rules(sketch_.parts.at(item.index).name, "");
    document_.remove(path_of(item));
    refresh();
}

void Draft::rename(std::size_t part, const std::string& name) {
    // A name that two have had is the other one's in the rules.
    const std::string before = sketch_.parts.at(part).name;
    if (std::ranges::count(sketch_.parts, before, &Part::name) == 1) name_in_rules(before, name);
    set({"parts", std::to_string(part), "name"}, name);
}

void Draft::name_in_rules(const std::string& before, const std::string& after) {
    const OrderedJson* rules = lab::find(document_.json(), {"rules"});
    if (rules != nullptr) document_.set({"rules"}, with_name(*rules, before, after));
}

void Draft::add_material(Path thing, const std::string& like) {
    OrderedJson copy = OrderedJson::object();
    if (const OrderedJson* other = lab::find(document_.json(), {"materials", like})) copy = *other;
    std::string name;
    for (int i = 1; name.empty() || lab::find(document_.json(), {"materials", name}) != nullptr; ++i)
        name = "material-" + std::to_string(i);
    if (lab::find(document_.json(), {"materials"}) == nullptr)
        document_.set({"materials"}, OrderedJson::object());
    document_.set({"materials", name}, copy);
    thing.emplace_back("material");
    set(thing, name);
}

void Draft::revert_step() {
    if (!document_.in_step()) return;
    document_.revert_step();
    refresh();
}

bool Draft::undo() {
    const bool some = document_.undo();
    if (some) refresh();
    return some;
}

bool Draft::redo() {
    const bool some = document_.redo();
    if (some) refresh();
    return some;
}

}  // namespace flipside::lab

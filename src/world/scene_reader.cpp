#include "world/scene_reader.hpp"

#include <algorithm>

#include "world/limits.hpp"
#include "world/printable.hpp"

namespace flipside {

namespace {

constexpr std::size_t most_layers = 32;

/// The key of an entry of a map.
constexpr auto key_of = [](const auto& entry) { return entry.first; };

}  // namespace

SceneReader::SceneReader(Scene& scene) : scene_(scene) {
    scene_.materials = {Material{}};
    scene_.layers = {"default"};
}

void SceneReader::add_material(const std::string& name, const Node& node) {
    materials_[name] = static_cast<std::uint32_t>(scene_.materials.size());
    scene_.materials.push_back(
        {name, node.real("restitution", 1), node.real("friction", 0), node.real("kick", 0)});
}

std::uint32_t SceneReader::material(const Node& node, const char* key) const {
    if (!node.has(key)) return 0;
    const std::string name = node.text(key);
    const auto found = materials_.find(name);
    if (found == materials_.end())
        node.fail(key, "unknown material " + in_quotes(name) + "; allowed: " + names_of(materials_, key_of));
    return found->second;
}

std::uint32_t SceneReader::layer(const Node& node) {
    const auto name = node.json().get<std::string>();
    const auto found = std::ranges::find(scene_.layers, name);
    const auto bit = found - scene_.layers.begin();
    if (found == scene_.layers.end()) {
        if (scene_.layers.size() == most_layers)
            node.fail("layer " + in_quotes(name) + " is one too many; allowed are 32, \"default\" included");
        scene_.layers.push_back(name);
    }
    return 1U << bit;
}

Ball SceneReader::ball_kind(const Node& node) {
    Ball ball;
    ball.radius = node.real("radius");
    ball.mass = node.real("mass");
    ball.material = material(node);
    read_layers(node, ball);
    return ball;
}

void SceneReader::add_ball(const Node& node, Ball ball) {
    if (scene_.balls.size() == most_things) node.fail("too many balls; allowed are 1000000 in a scene");
    if (!scene_.bounds.contains(ball.position))
        node.fail("a ball lies outside the bounds; allowed are places inside");
    if (!within_top_speed(ball))
        node.fail("a ball is too fast; allowed are speeds of its centre and its rim up to " +
                  Json(top_speed).dump() + " m/s");
    ball.number = static_cast<BallNumber>(scene_.balls.size());
    scene_.balls.push_back(ball);
}

void SceneReader::add_part(const Node& node, Part part) {
    if (scene_.parts.size() == most_things) node.fail("too many parts; allowed are 1000000 in a scene");
    const bool unfit =
        part.name.find_first_of(",\"") != std::string::npos || printable(part.name) != part.name;
    if (unfit || part.name.starts_with("ball:"))
        node.fail("name " + in_quotes(part.name) +
                  " cannot name a part; allowed: no commas, quotes or control characters, not \"ball:...\"");
    if (!parts_.emplace(part.name, static_cast<PartIndex>(scene_.parts.size())).second)
        node.fail("name " + in_quotes(part.name) + " is taken by another part; allowed are unique names");
    scene_.parts.push_back(std::move(part));
}

PartIndex SceneReader::part(const Node& node, const std::string& name) const {
    const auto found = parts_.find(name);
    if (found == parts_.end())
        node.fail("unknown part " + in_quotes(name) + "; allowed: " + names_of(parts_, key_of));
    return found->second;
}

}  // namespace flipside

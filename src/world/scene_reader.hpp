#pragma once
/// What the readers of a scene file share: one for shapes and motions, one for the launcher and the
/// rules, one for generators. scene_file.cpp puts them together.

#include <map>
#include <string>

#include "world/json_file.hpp"
#include "world/scene.hpp"

namespace flipside {

/// The scene that is being read, and how its names are found.
class SceneReader {
  public:
    explicit SceneReader(Scene& scene);

    [[nodiscard]] const Scene& scene() const { return scene_; }
    void add_material(const std::string& name, const Node& node);
    /// Index of the material named by `key`, 0 where there is no such key.
    [[nodiscard]] std::uint32_t material(const Node& node, const char* key = "material") const;
    /// Reads "layer" and "collides_with" of a ball or part.
    template <class Thing>
    void read_layers(const Node& node, Thing& thing) {
        if (node.has("layer")) thing.layer = layer(node.at("layer"));
        if (!node.has("collides_with")) return;
        thing.collides_with = 0;
        for (const Node& name : node.each("collides_with")) thing.collides_with |= layer(name);
    }
    /// A ball's radius, mass, material and layers.
    [[nodiscard]] Ball ball_kind(const Node& node);
    /// Numbers the ball; `node` is where it comes from. Refused outside the bounds.
    void add_ball(const Node& node, Ball ball);
    /// Refuses a name that is in use or invalid.
    void add_part(const Node& node, Part part);
    /// The part that a text names.
    [[nodiscard]] PartIndex part(const Node& node, const std::string& name) const;

  private:
    /// The bit of a layer; new names get the next bit.
    std::uint32_t layer(const Node& node);

    Scene& scene_;
    std::map<std::string, std::uint32_t> materials_;
    std::map<std::string, PartIndex> parts_;
};

[[nodiscard]] Box read_box(const Node& node);
[[nodiscard]] Shape read_shape(const Node& node);
[[nodiscard]] Motion read_motion(const Node& part, const Shape& shape);
[[nodiscard]] Launcher read_launcher(const Node& node, SceneReader& reader);
[[nodiscard]] Rules read_rules(const Node& node, const SceneReader& reader);
/// The bounds that a generated field sets.
[[nodiscard]] Box field_bounds(const Node& node);
/// Adds the balls and parts of a generator. Deterministic: Boost.Random's distributions are the same
/// everywhere.
void generate(const Node& generator, SceneReader& reader);

}  // namespace flipside

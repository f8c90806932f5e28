#pragma once
/// Parts and materials of a scene by their names, for readers of files that may name many of them.

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "world/scene.hpp"

namespace flipside {

/// Things by their names; a search takes the logarithm of their number.
class NameIndex {
  public:
    /// Of things that have a `name`. They must outlive this and keep their names.
    template <class Thing>
    explicit NameIndex(std::span<const Thing> things) {
        names_.reserve(things.size());
        for (std::uint32_t i = 0; i < things.size(); ++i) names_.push_back({things[i].name, i});
        sort();
    }
    /// The index of the first thing of that name.
    [[nodiscard]] std::optional<std::uint32_t> find(std::string_view name) const;

  private:
    struct Entry {
        std::string_view name;
        std::uint32_t index;
        friend auto operator<=>(const Entry&, const Entry&) = default;
    };
    void sort();

    std::vector<Entry> names_;
};

/// The scene must outlive this.
class SceneNames {
  public:
    explicit SceneNames(const Scene& scene) : scene_(&scene) {}

    [[nodiscard]] const Scene& scene() const { return *scene_; }
    [[nodiscard]] std::optional<PartIndex> part(std::string_view name) const;
    /// Never that of things that name none.
    [[nodiscard]] std::optional<std::uint32_t> material(std::string_view name) const;

  private:
    const Scene* scene_;
    mutable std::optional<NameIndex> parts_, materials_;  ///< made when first asked: few files name any
};

}  // namespace flipside

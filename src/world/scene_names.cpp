#include "world/scene_names.hpp"

#include <algorithm>

namespace flipside {

void NameIndex::sort() {
    std::ranges::sort(names_);
}

std::optional<std::uint32_t> NameIndex::find(std::string_view name) const {
    const auto at = std::ranges::lower_bound(names_, name, {}, &Entry::name);
    if (at == names_.end() || at->name != name) return std::nullopt;
    return at->index;
}

std::optional<PartIndex> SceneNames::part(std::string_view name) const {
    if (!parts_) parts_.emplace(std::span(scene_->parts));
    return parts_->find(name);
}

std::optional<std::uint32_t> SceneNames::material(std::string_view name) const {
    const std::span named = std::span(scene_->materials).subspan(1);
    if (!materials_) materials_.emplace(named);
    const auto found = materials_->find(name);
    if (!found) return std::nullopt;
    return *found + 1;
}

}  // namespace flipside

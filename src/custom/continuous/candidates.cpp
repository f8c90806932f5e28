#include "custom/continuous/candidates.hpp"

#include <algorithm>

namespace flipside::custom {

Box range_of(const Feature& feature, const Primitive& primitive, const Table& table) {
    const Box box = bounds_of(feature, primitive);
    if (!Table::moves(table.scene().parts[feature.part])) return box;
    const Vec2 pivot = table.pose(feature.part).pivot;
    const double dx = std::max(box.max.x - pivot.x, pivot.x - box.min.x);
    const double dy = std::max(box.max.y - pivot.y, pivot.y - box.min.y);
    return bounds_of(pivot, std::sqrt(dx * dx + dy * dy));
}

std::uint64_t Candidates::cover(const Box& box, const BoxIndex& feature_ranges) {
    if (fat_.contains(box.min) && fat_.contains(box.max)) return 0;
    const Vec2 size = box.max - box.min;
    // A wider margin makes longer lists, a narrower one more rebuilds; measured on pinball.
    constexpr double margin = 0.25;  // of width plus height
    fat_ = grown(box, margin * (size.x + size.y));
    list_.clear();
    return feature_ranges.find(fat_, list_);
}

}  // namespace flipside::custom

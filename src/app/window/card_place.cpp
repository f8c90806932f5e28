#include "app/window/card_place.hpp"

#include <algorithm>
#include <array>

namespace flipside::app {

namespace {

double overlap(const Rect& a, const Rect& b) {
    const double width = std::min(a.x + a.width, b.x + b.width) - std::max(a.x, b.x);
    const double height = std::min(a.y + a.height, b.y + b.height) - std::max(a.y, b.y);
    return std::max(0.0, width) * std::max(0.0, height);
}

}  // namespace

Rect CardPlace::put(Vec2 size, const Rect& panes, const Rect& window, std::span<const Rect> watched) {
    const auto at = [&](Vec2 corner) {
        const double right = std::max(0.0, window.width - size.x),
                     low = std::max(0.0, window.height - size.y);
        return Rect{std::clamp(corner.x, 0.0, right), std::clamp(corner.y, 0.0, low), size.x, size.y};
    };
    if (moved_) return place_ = at(*moved_);
    const double right = panes.x + panes.width - size.x, low = panes.y + panes.height - size.y;
    const std::array corners{Vec2{right, panes.y}, Vec2{right, low}, Vec2{panes.x, panes.y},
                             Vec2{panes.x, low}};
    const auto covered = [&](int corner) {
        double area = 0;
        for (const Rect& spot : watched) area += overlap(at(corners[static_cast<std::size_t>(corner)]), spot);
        return area;
    };
    for (int corner = 0; corner < static_cast<int>(corners.size()); ++corner)
        if (covered(corner) < covered(corner_)) corner_ = corner;
    return place_ = at(corners[static_cast<std::size_t>(corner_)]);
}

}  // namespace flipside::app

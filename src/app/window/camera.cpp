#include "app/window/camera.hpp"

#include <algorithm>

namespace flipside::app {

void Camera::fit(const Box& box, double margin) {
    const Vec2 extent = box.max - box.min;
    center = 0.5 * (box.min + box.max);
    scale = std::min(std::max(1.0, size.x - 2 * margin) / extent.x,
                     std::max(1.0, size.y - 2 * margin) / extent.y);
}

void Camera::zoom(Vec2 pixel, double factor) {
    const Vec2 held = to_metres(pixel);
    scale = std::clamp(scale * factor, 1.0, 1e6);
    center += held - to_metres(pixel);
}

void Camera::pan(Vec2 pixels) {
    center += Vec2{-pixels.x, pixels.y} / scale;
}

}  // namespace flipside::app

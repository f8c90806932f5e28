#include "app/window/mouse.hpp"

#include <algorithm>
#include <cmath>

namespace flipside::app {

namespace {

const Rect* pane_at(const Layout& layout, Vec2 p) {
    const auto found =
        std::ranges::find_if(layout.panes, [p](const Rect& pane) { return pane.contains(p.x, p.y); });
    return found == layout.panes.end() ? nullptr : &*found;
}

}  // namespace

void PaneMouse::process(const sf::Event& event, double now, const Layout& layout, Camera& camera) {
    switch (event.type) {
        case sf::Event::MouseWheelScrolled: {
            const Vec2 at{double(event.mouseWheelScroll.x), double(event.mouseWheelScroll.y)};
            const Rect* pane = pane_at(layout, at);
            if (!pane) return;
            camera.zoom(at - Vec2{pane->x, pane->y}, std::pow(1.15, event.mouseWheelScroll.delta));
            fitted_ = false;
            break;
        }
        case sf::Event::MouseButtonPressed:
            if (event.mouseButton.button == sf::Mouse::Left)
                press({double(event.mouseButton.x), double(event.mouseButton.y)}, now, layout);
            break;
        case sf::Event::MouseButtonReleased:
            dragging_ = false;
            break;
        case sf::Event::MouseMoved: {
            const Vec2 at{double(event.mouseMove.x), double(event.mouseMove.y)};
            if (dragging_ && length(at - pressed_) > double_click_pixels) {
                camera.pan(at - last_);
                fitted_ = false;
            }
            last_ = at;
            break;
        }
        default:
            break;
    }
}

void PaneMouse::press(Vec2 at, double now, const Layout& layout) {
    if (!pane_at(layout, at)) return;
    if (now - pressed_at_ < double_click_seconds && length(at - pressed_) < double_click_pixels)
        fitted_ = true;
    dragging_ = true;
    pressed_ = last_ = at;
    pressed_at_ = now;
}

}  // namespace flipside::app

#include "app/window/constructions.hpp"

#include <cmath>
#include <cstdio>

namespace flipside::app {

void Construction::fill(std::span<const Vec2> metres, sf::Color drawn) const {
    std::vector<Vec2> pixels;
    pixels.reserve(metres.size());
    for (const Vec2 point : metres) pixels.push_back(at(point));
    canvas.fill(pixels, drawn);
}

void Construction::frame(const Box& box, double width, sf::Color drawn) const {
    const Vec2 a = at(box.min), b = at(box.max);
    const Vec2 corners[] = {a, {b.x, a.y}, b, {a.x, b.y}};
    canvas.stroke(corners, true, canvas.scaled(width), drawn);
}

std::string short_length(double metres) {
    char text[32];
    const bool long_one = std::abs(metres) >= 1;
    std::snprintf(text, sizeof text, long_one ? "%.3g m" : "%.3g mm", (long_one ? 1 : 1e3) * metres + 0.0);
    return text;
}

}  // namespace flipside::app

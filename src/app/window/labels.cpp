#include "app/window/labels.hpp"

#include <algorithm>

namespace flipside::app {

bool Labels::is_free(const Rect& place) const {
    return place.y >= top_ && place.y + place.height <= size_.y &&
           std::ranges::none_of(places_, [&](const Rect& other) {
               return place.x < other.x + other.width && other.x < place.x + place.width &&
                      place.y < other.y + other.height && other.y < place.y + place.height;
           });
}

void Labels::put(Vec2 at, std::string_view words, sf::Color color, Type type) {
    const double pad = canvas_.scaled(3);
    const double width = canvas_.lettering().width(words, type) + 2 * pad;
    const double height = canvas_.lettering().line_height(type);
    Rect place{std::clamp(at.x - 0.5 * width, 0.0, std::max(0.0, size_.x - width)), at.y - 0.5 * height,
               width, height};
    const double wanted = place.y;
    constexpr int most_tries = 40;
    for (int k = 0; k < most_tries && !is_free(place); ++k)
        place.y = wanted + (k % 2 == 0 ? k + 2 : -k - 1) * 0.25 * height;
    if (!is_free(place)) return;
    places_.push_back(place);
    canvas_.rectangle({place.x, place.y}, {place.x + width, place.y + height},
                      with_alpha(colour::table, 0.8));
    canvas_.text({place.x + pad, place.y}, words, type, color);
}

void Labels::put_beside(Vec2 at, Vec2 direction, double gap, std::string_view words, sf::Color color,
                        Type type) {
    const Vec2 way = length_squared(direction) > 0 ? unit(direction) : Vec2{0, 1};
    const Vec2 half{0.5 * canvas_.lettering().width(words, type) + canvas_.scaled(3),
                    0.5 * canvas_.lettering().line_height(type)};
    put(at + canvas_.scaled(gap) * way + Vec2{way.x * half.x, way.y * half.y}, words, color, type);
}

}  // namespace flipside::app

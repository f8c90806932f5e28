#include "app/window/led.hpp"

#include <array>

namespace flipside::app {

namespace {

constexpr double advance = 0.68, face = 0.48;  ///< of the height

/// Segments a to g, bit 0 to 6, of each figure.
constexpr std::array<unsigned, 10> lit_segments = {0x3f, 0x06, 0x5b, 0x4f, 0x66,
                                                   0x6d, 0x7d, 0x07, 0x7f, 0x6f};

struct Bar {
    Vec2 a, b;  ///< of a figure 1 wide and 2 high
};
constexpr std::array<Bar, 7> bars = {{{{0, 0}, {1, 0}},
                                      {{1, 0}, {1, 1}},
                                      {{1, 1}, {1, 2}},
                                      {{0, 2}, {1, 2}},
                                      {{0, 1}, {0, 2}},
                                      {{0, 0}, {0, 1}},
                                      {{0, 1}, {1, 1}}}};

}  // namespace

double led_width(int digits, double height) {
    return digits * advance * height;
}

void draw_led(Canvas& canvas, Vec2 at, double height, int digits, long number, sf::Color color) {
    const double width = face * height, half = 0.5 * height, thick = 0.13 * height, gap = 0.06 * height;
    for (int digit = digits - 1; digit >= 0; --digit, number /= 10) {
        const bool leading = number == 0 && digit < digits - 1;
        const unsigned lit = leading ? 0 : lit_segments[static_cast<std::size_t>(number % 10)];
        const Vec2 corner = at + Vec2{(digit * advance + 0.1) * height, 0};
        for (std::size_t i = 0; i < bars.size(); ++i) {
            // The figures lean a little, as they do.
            const auto place = [&](Vec2 p) {
                return corner + Vec2{p.x * width + (2 - p.y) * 0.05 * height, p.y * half};
            };
            const Vec2 a = place(bars[i].a), b = place(bars[i].b), in = gap * unit(b - a);
            canvas.line(a + in, b - in, thick, with_alpha(color, (lit >> i & 1U) != 0 ? 1 : 0.1));
        }
    }
}

}  // namespace flipside::app

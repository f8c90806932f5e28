#include "app/window/lettering.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <SFML/System/String.hpp>

#include "world/printable.hpp"

namespace flipside::app {

namespace {

bool is_digit(sf::Uint32 letter) {
    return letter >= '0' && letter <= '9';
}

/// What is no text is shown as its escape, as everywhere (printable.hpp).
sf::String decode(std::string_view utf8) {
    const std::string shown = printable(utf8);
    return sf::String::fromUtf8(shown.begin(), shown.end());
}

}  // namespace

Lettering::Lettering(double scale) : scale_(scale) {
    const FontFiles files = find_fonts();
    if (!fonts_[0].loadFromFile(files.regular.string()) || !fonts_[1].loadFromFile(files.strong.string()))
        throw std::runtime_error("cannot read the font " + files.regular.string());
    for (const Type type : types)
        for (sf::Uint32 digit = '0'; digit <= '9'; ++digit) {
            double& widest = digit_width_[static_cast<int>(type)];
            widest = std::max<double>(widest, font(type).getGlyph(digit, pixels(type), false).advance);
        }
}

unsigned Lettering::pixels(Type type) const {
    constexpr double sizes[] = {small_type, large_type, title_type};
    return static_cast<unsigned>(std::lround(scale_ * sizes[static_cast<int>(type)]));
}

double Lettering::advance(sf::Uint32 letter, Type type) const {
    return is_digit(letter) ? digit_width_[static_cast<int>(type)]
                            : font(type).getGlyph(letter, pixels(type), false).advance;
}

double Lettering::width(std::string_view utf8, Type type) const {
    double sum = 0;
    for (const sf::Uint32 letter : decode(utf8)) sum += advance(letter, type);
    return sum;
}

double Lettering::line_height(Type type) const {
    return font(type).getLineSpacing(pixels(type));
}

std::vector<std::string> Lettering::lines(std::string_view utf8, Type type, double room,
                                          std::size_t most) const {
    if (utf8.empty()) return {};
    return in_lines(
        utf8, [&](const std::string& words) { return width(words, type) <= room; }, most);
}

std::string Lettering::cut(std::string_view utf8, Type type, double room) const {
    return shortened(std::string(utf8), [&](const std::string& words) { return width(words, type) <= room; });
}

const sf::Texture& Lettering::texture(Type type) const {
    return font(type).getTexture(pixels(type));
}

void Lettering::write(sf::VertexArray& out, Vec2 at, std::string_view utf8, Type type,
                      sf::Color color) const {
    double pen = at.x;
    const double baseline = std::round(at.y + 0.8 * line_height(type));
    for (const sf::Uint32 letter : decode(utf8)) {
        const sf::Glyph& glyph = font(type).getGlyph(letter, pixels(type), false);
        const double step = advance(letter, type);
        const auto left =
            static_cast<float>(std::round(pen + 0.5 * (step - glyph.advance))) + glyph.bounds.left;
        const float top = static_cast<float>(baseline) + glyph.bounds.top;
        const sf::FloatRect from(glyph.textureRect);
        const auto corner = [&](float x, float y) {
            return sf::Vertex({left + x * glyph.bounds.width, top + y * glyph.bounds.height}, color,
                              {from.left + x * from.width, from.top + y * from.height});
        };
        for (const sf::Vertex& vertex : {corner(0, 0), corner(1, 0), corner(1, 1)}) out.append(vertex);
        for (const sf::Vertex& vertex : {corner(0, 0), corner(1, 1), corner(0, 1)}) out.append(vertex);
        pen += step;
    }
}

}  // namespace flipside::app

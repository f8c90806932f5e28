#pragma once
/// Text on the canvas, in two sizes and one for titles on the table, with figures of equal width so that
/// changing numbers stand still.

#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include <SFML/Graphics/Font.hpp>
#include <SFML/Graphics/VertexArray.hpp>

#include "app/window/theme.hpp"
#include "app/window/words.hpp"
#include "world/vec2.hpp"

namespace flipside::app {

enum class Type { small, large, title };
inline constexpr Type types[] = {Type::small, Type::large, Type::title};

class Lettering {
  public:
    /// Throws std::runtime_error when there are no fonts.
    explicit Lettering(double scale);

    /// px.
    [[nodiscard]] double width(std::string_view utf8, Type type) const;
    [[nodiscard]] double line_height(Type type) const;
    /// In lines of at most `room` px (words.hpp); of nothing none.
    [[nodiscard]] std::vector<std::string> lines(std::string_view utf8, Type type, double room,
                                                 std::size_t most = any_number) const;
    /// As much of it as `room` px hold, with "…" where the end is missing.
    [[nodiscard]] std::string cut(std::string_view utf8, Type type, double room) const;
    /// Adds the letters' rectangles (triangles, to be drawn with texture(type)). `at` is the top left of
    /// the line.
    void write(sf::VertexArray& out, Vec2 at, std::string_view utf8, Type type, sf::Color color) const;
    [[nodiscard]] const sf::Texture& texture(Type type) const;
    [[nodiscard]] double scale() const { return scale_; }

  private:
    [[nodiscard]] unsigned pixels(Type type) const;
    [[nodiscard]] const sf::Font& font(Type type) const { return fonts_[type == Type::small ? 0 : 1]; }
    [[nodiscard]] double advance(sf::Uint32 letter, Type type) const;

    double scale_;
    sf::Font fonts_[2];                       ///< regular for the small type, strong for the others
    double digit_width_[std::size(types)]{};  ///< of the widest figure, px
};

}  // namespace flipside::app

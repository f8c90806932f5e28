#pragma once
/// The look of the window: its colours and its fonts, in one place.

#include <filesystem>
#include <string_view>

#include <SFML/Graphics/Color.hpp>

namespace flipside::app {

namespace colour {

inline const sf::Color around(0x0d, 0x0f, 0x12);
inline const sf::Color table(0x14, 0x17, 0x1c);
inline const sf::Color raised(0x1d, 0x21, 0x28);  ///< headers, panel, plots
inline const sf::Color rule(0x2c, 0x32, 0x3b);    ///< thin dividing lines
inline const sf::Color text(0xdd, 0xe1, 0xe6);
inline const sf::Color quiet(0x8b, 0x93, 0x9e);  ///< text that matters less
inline const sf::Color warning(0xd5, 0x5e, 0x00);
inline const sf::Color part(0xa3, 0x99, 0x8c);    ///< walls
inline const sf::Color solid(0x3a, 0x36, 0x31);   ///< inside of solid parts
inline const sf::Color kicker(0xc9, 0x8b, 0x5a);  ///< rim of an active kicker
inline const sf::Color lit(0xff, 0xe0, 0x9a);     ///< a part that was just hit
inline const sf::Color sensor(0x6d, 0x76, 0x82);
inline const sf::Color boxes(0xc2, 0xcb, 0xd6);
inline const sf::Color cells(0xd4, 0x7a, 0xd4);
inline const sf::Color pairs(0xf0, 0xe4, 0x42);
inline const sf::Color sectors(0x8f, 0x8c, 0xf5);
inline const sf::Color tangents(0xf2, 0x95, 0xa8);

}  // namespace colour

/// The one colour of an engine, everywhere; readable with every kind of colour blindness (Okabe and Ito 2008,
/// "Color Universal Design").
[[nodiscard]] sf::Color engine_colour(std::string_view engine);
[[nodiscard]] sf::Color with_alpha(sf::Color color, double alpha);
/// From a (t = 0) to b (t = 1).
[[nodiscard]] sf::Color blend(sf::Color a, sf::Color b, double t);

struct FontFiles {
    std::filesystem::path regular, strong;
};
/// Inter, else DejaVu Sans, from where systems keep them. Throws std::runtime_error that says what to
/// install.
[[nodiscard]] FontFiles find_fonts();

/// Heights of the two sizes of type on an ordinary display, and of titles on the table, px.
inline constexpr double small_type = 14, large_type = 19, title_type = 30;

}  // namespace flipside::app

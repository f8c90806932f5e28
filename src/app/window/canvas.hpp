#pragma once
/// Anti-aliased shapes and text, collected in vertex arrays and drawn in two or three calls. Everything is
/// in pixels, y down. Edges are softened by a border one pixel wide that fades to nothing, so no
/// multisampling is needed and a picture looks the same on every machine.

#include <span>
#include <string_view>
#include <vector>

#include <SFML/Graphics/RenderTarget.hpp>
#include <SFML/Graphics/VertexArray.hpp>

#include "app/window/lettering.hpp"
#include "world/vec2.hpp"

namespace flipside::app {

enum class Align { left, center, right };

class Canvas {
  public:
    explicit Canvas(const Lettering& lettering);

    void stroke(std::span<const Vec2> points, bool closed, double width, sf::Color color);
    void line(Vec2 a, Vec2 b, double width, sf::Color color);
    /// A line with a head at b.
    void arrow(Vec2 a, Vec2 b, double width, sf::Color color);
    /// A line that narrows and fades away from its first point to its last.
    void trail(std::span<const Vec2> points, double width, sf::Color color);
    /// Angles in radians, anticlockwise as seen on the screen.
    void arc(Vec2 center, double radius, double from, double to, double width, sf::Color color);
    void ring(Vec2 center, double radius, double width, sf::Color color);
    void disc(Vec2 center, double radius, sf::Color color);
    /// A disc shaded as a steel ball, lit from the upper left, under a tint.
    void steel(Vec2 center, double radius, sf::Color tint, double alpha = 1);
    /// Convex, either sense.
    void fill(std::span<const Vec2> polygon, sf::Color color);
    void rectangle(Vec2 min, Vec2 max, sf::Color color);
    /// `at` is the top left, top middle or top right of the line. Text lies over all shapes.
    void text(Vec2 at, std::string_view utf8, Type type, sf::Color color, Align align = Align::left);

    [[nodiscard]] const Lettering& lettering() const { return lettering_; }
    /// px on this display for a length of `pixels` on an ordinary one.
    [[nodiscard]] double scaled(double pixels) const { return lettering_.scale() * pixels; }
    /// Draws what was collected, and forgets it.
    void flush(sf::RenderTarget& target);

  private:
    void triangle(Vec2 a, sf::Color ca, Vec2 b, sf::Color cb, Vec2 c, sf::Color cc);
    void quad(Vec2 a, Vec2 b, sf::Color ab, Vec2 c, Vec2 d, sf::Color cd);
    /// Of a line without sharp corners.
    void stroke_smooth(std::span<const Vec2> points, bool closed, double width, sf::Color color);
    void round(Vec2 center, double radius, double from, double to);

    const Lettering& lettering_;
    sf::VertexArray shapes_{sf::Triangles};
    sf::VertexArray letters_[std::size(types)]{sf::VertexArray(sf::Triangles), sf::VertexArray(sf::Triangles),
                                               sf::VertexArray(sf::Triangles)};
    std::vector<Vec2> points_;   ///< scratch: a curve as a polygon
    std::vector<Vec2> offsets_;  ///< scratch: outward unit mitres
};

}  // namespace flipside::app

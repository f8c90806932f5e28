#include "app/window/canvas.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace flipside::app {

namespace {

using std::numbers::pi;

sf::Vector2f vector(Vec2 p) {
    return {static_cast<float>(p.x), static_cast<float>(p.y)};
}

/// Straight primitives for an arc such that no primitive is off by more than a seventh of a pixel.
int primitives(double radius, double angle) {
    const double step = 2 * std::acos(1 - std::min(0.5, 0.14 / std::max(radius, 0.3)));
    return std::clamp(static_cast<int>(std::ceil(angle / step)), 2, 4096);
}

/// At each point of a line, the direction across it, as long as a mitre joint asks (at most 2).
void mitres(std::span<const Vec2> points, bool closed, std::vector<Vec2>& out) {
    const std::size_t n = points.size();
    out.resize(n);
    for (std::size_t i = 0; i < n; ++i) {
        const Vec2 before = points[i > 0 ? i - 1 : closed ? n - 1 : 0];
        const Vec2 after = points[i + 1 < n ? i + 1 : closed ? 0 : n - 1];
        const Vec2 in = unit(perp(points[i] - before), {0, 0}), on = unit(perp(after - points[i]), {0, 0});
        const Vec2 across = unit(in + on, in);
        const double cosine = std::max({dot(across, in), dot(across, on), 0.5});
        out[i] = across / cosine;
    }
}

/// Whether a line turns by more than 120° at b. A mitre joint would lie along the line there, and the line
/// would be hardly as wide as a hair on both sides: it ends, and another one begins.
bool is_sharp(Vec2 a, Vec2 b, Vec2 c) {
    return dot(unit(b - a, {0, 0}), unit(c - b, {0, 0})) < -0.5;
}

}  // namespace

Canvas::Canvas(const Lettering& lettering) : lettering_(lettering) {}

void Canvas::triangle(Vec2 a, sf::Color ca, Vec2 b, sf::Color cb, Vec2 c, sf::Color cc) {
    shapes_.append({vector(a), ca});
    shapes_.append({vector(b), cb});
    shapes_.append({vector(c), cc});
}

void Canvas::quad(Vec2 a, Vec2 b, sf::Color ab, Vec2 c, Vec2 d, sf::Color cd) {
    triangle(a, ab, b, ab, c, cd);
    triangle(c, cd, d, cd, a, ab);
}

void Canvas::stroke(std::span<const Vec2> points, bool closed, double width, sf::Color color) {
    std::size_t first = 0;
    for (std::size_t i = 1; !closed && i + 1 < points.size(); ++i)
        if (is_sharp(points[i - 1], points[i], points[i + 1])) {
            stroke_smooth(points.subspan(first, i + 1 - first), false, width, color);
            first = i;
        }
    stroke_smooth(points.subspan(first), closed, width, color);
}

void Canvas::stroke_smooth(std::span<const Vec2> points, bool closed, double width, sf::Color color) {
    if (points.size() < 2) return;
    if (width < 1) color = with_alpha(color, width);
    const double core = 0.5 * (std::max(width, 1.0) - 1), edge = core + 1;
    const sf::Color clear = with_alpha(color, 0);
    mitres(points, closed, offsets_);
    const std::size_t n = points.size();
    for (std::size_t i = 0; i + 1 < n + (closed ? 1 : 0); ++i) {
        const std::size_t j = (i + 1) % n;
        const Vec2 p = points[i], q = points[j], a = offsets_[i], b = offsets_[j];
        quad(p + edge * a, q + edge * b, clear, q + core * b, p + core * a, color);
        if (core > 0) quad(p + core * a, q + core * b, color, q - core * b, p - core * a, color);
        quad(p - core * a, q - core * b, color, q - edge * b, p - edge * a, clear);
    }
    // Round ends, so that lines that meet leave no notch. Through glass they would show twice.
    if (closed || width < 2 || color.a < 255) return;
    const Vec2 first = points.front(), last = points.back();
    disc(first, 0.5 * width, color);
    disc(last, 0.5 * width, color);
}

void Canvas::trail(std::span<const Vec2> points, double width, sf::Color color) {
    if (points.size() < 2) return;
    mitres(points, false, offsets_);
    const auto left = [&](std::size_t i) {
        return 1 - static_cast<double>(i) / static_cast<double>(points.size() - 1);
    };
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const Vec2 p = points[i], q = points[i + 1];
        const Vec2 a = 0.5 * width * left(i) * offsets_[i], b = 0.5 * width * left(i + 1) * offsets_[i + 1];
        const sf::Color near = with_alpha(color, left(i)), far = with_alpha(color, left(i + 1));
        const sf::Color none = with_alpha(color, 0);
        for (const double side : {1.0, -1.0}) {  // dense in the middle, nothing at the rim
            triangle(p, near, q, far, p + side * a, none);
            triangle(p + side * a, none, q, far, q + side * b, none);
        }
    }
}

void Canvas::line(Vec2 a, Vec2 b, double width, sf::Color color) {
    const Vec2 ends[] = {a, b};
    stroke(ends, false, width, color);
}

void Canvas::arrow(Vec2 a, Vec2 b, double width, sf::Color color) {
    const double head = std::min(length(b - a), 4 * width + 3);
    const Vec2 along = unit(b - a, {0, 0});
    const Vec2 neck = b - head * along;
    line(a, neck, width, color);
    const Vec2 corners[] = {b, neck + 0.5 * head * perp(along), neck - 0.5 * head * perp(along)};
    fill(corners, color);
}

void Canvas::round(Vec2 center, double radius, double from, double to) {
    const int n = primitives(radius, to - from);
    points_.clear();
    for (int i = 0; i <= n; ++i) {
        const Vec2 d = from_angle(from + (to - from) * i / n);
        points_.push_back({center.x + radius * d.x, center.y - radius * d.y});
    }
}

void Canvas::arc(Vec2 center, double radius, double from, double to, double width, sf::Color color) {
    round(center, radius, from, to);
    stroke_smooth(points_, false, width, color);
}

void Canvas::ring(Vec2 center, double radius, double width, sf::Color color) {
    round(center, radius, 0, 2 * pi);
    points_.pop_back();
    stroke_smooth(points_, true, width, color);
}

void Canvas::disc(Vec2 center, double radius, sf::Color color) {
    round(center, radius, 0, 2 * pi);
    points_.pop_back();
    fill(points_, color);
}

void Canvas::steel(Vec2 center, double radius, sf::Color tint, double alpha) {
    const auto shade = [tint, alpha](sf::Uint8 grey) {
        const sf::Color steel(grey, static_cast<sf::Uint8>(grey + 3), static_cast<sf::Uint8>(grey + 8));
        const sf::Color tinted(static_cast<sf::Uint8>(tint.r * grey / 255),
                               static_cast<sf::Uint8>(tint.g * grey / 255),
                               static_cast<sf::Uint8>(tint.b * grey / 255));
        return with_alpha(blend(steel, tinted, tint.a / 255.0), alpha);
    };
    const sf::Color dark = shade(70), middle = shade(150), bright = shade(245);
    disc(center, radius, dark);
    const Vec2 light = center + radius * Vec2{-0.32, -0.36};
    const Vec2 half = center + 0.45 * (light - center);
    const int n = primitives(radius, 2 * pi);
    for (int i = 0; i < n; ++i) {
        const Vec2 d = from_angle(2 * pi * i / n), e = from_angle(2 * pi * (i + 1) / n);
        const double inner = 0.55 * radius, outer = std::max(0.0, radius - 0.5);
        triangle(light, bright, half + inner * d, middle, half + inner * e, middle);
        quad(half + inner * d, half + inner * e, middle, center + outer * e, center + outer * d, dark);
    }
}

void Canvas::fill(std::span<const Vec2> polygon, sf::Color color) {
    if (polygon.size() < 3) return;
    double area = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i)
        area += cross(polygon[i] - polygon[0], polygon[(i + 1) % polygon.size()] - polygon[0]);
    const double inward = area > 0 ? 0.5 : -0.5;
    mitres(polygon, true, offsets_);
    const sf::Color clear = with_alpha(color, 0);
    const auto inside = [&](std::size_t i) { return polygon[i] + inward * offsets_[i]; };
    const auto outside = [&](std::size_t i) { return polygon[i] - inward * offsets_[i]; };
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const std::size_t j = (i + 1) % polygon.size();
        if (i > 0 && j > 0) triangle(inside(0), color, inside(i), color, inside(j), color);
        quad(inside(i), inside(j), color, outside(j), outside(i), clear);
    }
}

void Canvas::rectangle(Vec2 min, Vec2 max, sf::Color color) {
    quad(min, {max.x, min.y}, color, max, {min.x, max.y}, color);
}

void Canvas::text(Vec2 at, std::string_view utf8, Type type, sf::Color color, Align align) {
    if (align == Align::center) at.x -= 0.5 * lettering_.width(utf8, type);
    if (align == Align::right) at.x -= lettering_.width(utf8, type);
    lettering_.write(letters_[static_cast<int>(type)], {std::round(at.x), at.y}, utf8, type, color);
}

void Canvas::flush(sf::RenderTarget& target) {
    target.draw(shapes_);
    shapes_.clear();
    for (const Type type : types) {
        sf::VertexArray& letters = letters_[static_cast<int>(type)];
        target.draw(letters, &lettering_.texture(type));
        letters.clear();
    }
}

}  // namespace flipside::app

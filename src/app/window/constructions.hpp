#pragma once
/// Draws how an item of a stage came to its result: the picked one in the step bar, with words at the lines.

#include <span>
#include <string>

#include "app/window/camera.hpp"
#include "app/window/labels.hpp"
#include "world/trace.hpp"

namespace flipside::app {

/// What is drawn of, on what, and where words go.
struct Construction {
    Canvas& canvas;
    const Camera& camera;
    Labels& labels;
    const TraceStage& stage;
    const TraceItem& item;
    sf::Color color;  ///< of the engine

    /// A field of the item, or null.
    template <class T>
    [[nodiscard]] const T* value(std::string_view name) const {
        const TraceValue* found = item.find(name);
        return found == nullptr ? nullptr : std::get_if<T>(found);
    }
    [[nodiscard]] Vec2 at(Vec2 metres) const { return camera.to_pixels(metres); }
    void line(Vec2 a, Vec2 b, double width, sf::Color drawn) const {
        canvas.line(at(a), at(b), canvas.scaled(width), drawn);
    }
    void fill(std::span<const Vec2> metres, sf::Color drawn) const;
    void frame(const Box& box, double width, sf::Color drawn) const;
    /// Beside `place`, in a direction of the world, `gap` px from it.
    void word(Vec2 place, Vec2 direction, double gap, std::string_view words, sf::Color drawn,
              Type type = Type::small) const {
        labels.put_beside(at(place), {direction.x, -direction.y}, gap, words, drawn, type);
    }
    /// m, of a length on the screen.
    [[nodiscard]] double metres(double pixels) const { return canvas.scaled(pixels) / camera.scale; }
};

/// Of a disc and a primitive: the foot, where it was clamped to, the region that decided, the separation.
void draw_closest(const Construction& drawn);
/// Of a disc and a polygon: every axis with both shadows, the one that decided in bold.
void draw_axes(const Construction& drawn);
/// Of a tree: a cell with its parent and children, or the cells that the search of a pair went to.
void draw_cells(const Construction& drawn);
/// Of a ball on its way, and of the one that it meets: what they sweep, until when. Radii in m.
void draw_sweep(const Construction& drawn, double radius, double other_radius);

/// "12.3 mm", "1.2 m".
[[nodiscard]] std::string short_length(double metres);

}  // namespace flipside::app

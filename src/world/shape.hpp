#pragma once
/// Shapes of parts: plain data as in the scene file. Lengths in metres.
/// Ends of segments and arcs collide as points. Segments, arcs, polylines and gates have no inside and
/// act on both sides; circles, polygons, capsules and flippers are solid.

#include <variant>
#include <vector>

#include "world/vec2.hpp"

namespace flipside {

struct Shape;

namespace shape {

struct Point {
    Vec2 at;
};
struct Segment {
    Vec2 a, b;
};
/// Anticlockwise from `from` to `to`, radians, from < to ≤ from + 2π.
struct Arc {
    Vec2 center;
    double radius = 0;
    double from = 0;
    double to = 0;
};
struct Circle {
    Vec2 center;
    double radius = 0;
};
/// Convex; corners anticlockwise (the loader reverses clockwise ones).
struct Polygon {
    std::vector<Vec2> points;
};
struct Capsule {
    Vec2 a, b;
    double radius = 0;
};
/// A circle about the pivot and a smaller one `length` away, joined by their outer tangents; `rest` is
/// the direction from pivot to tip when the flipper is down.
struct Flipper {
    Vec2 pivot;
    double length = 0;
    double base_radius = 0;
    double tip_radius = 0;
    double rest = 0;
};
struct Polyline {
    std::vector<Vec2> points;
    bool closed = false;
};
/// Passes a ball that moves along `normal`, reflects one in the other direction, and stays open while
/// a ball is in it: see gate.hpp.
struct Gate {
    Vec2 a, b;
    Vec2 normal;
};
/// Several shapes moved as one.
struct Compound {
    std::vector<Shape> of;
};

}  // namespace shape

struct Shape {
    std::variant<shape::Point, shape::Segment, shape::Arc, shape::Circle, shape::Polygon, shape::Capsule,
                 shape::Flipper, shape::Polyline, shape::Gate, shape::Compound>
        is;
};

}  // namespace flipside

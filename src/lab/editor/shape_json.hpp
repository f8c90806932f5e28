#pragma once
/// How shapes stand in a scene's document: reading their numbers, and writing them short.

#include "lab/editor/sketch.hpp"

namespace flipside::lab {

/// The least radius that a hand makes, m.
inline constexpr double least_radius = 1e-4;

/// To nine digits after the point: 1 nm, or 1e-9 of a degree.
[[nodiscard]] double to_nine_digits(double value);
[[nodiscard]] OrderedJson length_json(double metres);
[[nodiscard]] OrderedJson place_json(Vec2 v);
[[nodiscard]] OrderedJson degrees_json(double radians);

[[nodiscard]] double value_of(const OrderedJson& json, const char* key);
/// rad, of a key in degrees.
[[nodiscard]] double angle_in(const OrderedJson& json, const char* key);
/// The shape of a part, or the thing itself.
[[nodiscard]] const OrderedJson& shape_in(const OrderedJson& thing);
[[nodiscard]] OrderedJson& shape_in(OrderedJson& thing);
/// "" of what is no shape.
[[nodiscard]] std::string type_of(const OrderedJson& shape);
/// The places that are corners or ends, in the order of their index.
[[nodiscard]] std::vector<Vec2> corners_of(const OrderedJson& shape);
/// Whether the last corner is joined to the first.
[[nodiscard]] bool is_closed(const OrderedJson& shape);
[[nodiscard]] Vec2 arc_point(const OrderedJson& arc, double angle);

}  // namespace flipside::lab

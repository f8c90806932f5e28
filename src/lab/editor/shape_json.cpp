#include "lab/editor/shape_json.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace flipside::lab {

double to_nine_digits(double value) {
    constexpr double per_unit = 1e9;
    const double scaled = std::round(value * per_unit);
    return scaled / per_unit + 0.0;  // no negative zero
}

OrderedJson length_json(double metres) {
    return number(std::max(least_radius, to_nine_digits(metres)));
}

OrderedJson place_json(Vec2 v) {
    return to_pair({to_nine_digits(v.x), to_nine_digits(v.y)});
}

OrderedJson degrees_json(double radians) {
    return number(to_nine_digits(radians * 180 / std::numbers::pi));
}

double value_of(const OrderedJson& json, const char* key) {
    return json.at(key).get<double>();
}

double angle_in(const OrderedJson& json, const char* key) {
    return value_of(json, key) * std::numbers::pi / 180;
}

const OrderedJson& shape_in(const OrderedJson& thing) {
    return thing.contains("shape") ? thing.at("shape") : thing;
}
OrderedJson& shape_in(OrderedJson& thing) {
    return thing.contains("shape") ? thing.at("shape") : thing;
}

std::string type_of(const OrderedJson& shape) {
    return shape.value("type", "");
}

std::vector<Vec2> corners_of(const OrderedJson& shape) {
    std::vector<Vec2> corners;
    if (shape.contains("points"))
        for (const OrderedJson& point : shape.at("points")) corners.push_back(vector_of(point));
    for (const char* key : {"at", "a", "b", "min", "max"})
        if (shape.contains(key)) corners.push_back(vector_of(shape.at(key)));
    return corners;
}

bool is_closed(const OrderedJson& shape) {
    return type_of(shape) == "polygon" || shape.value("closed", false);
}

Vec2 arc_point(const OrderedJson& arc, double angle) {
    return vector_of(arc.at("center")) + value_of(arc, "radius") * from_angle(angle);
}

}  // namespace flipside::lab

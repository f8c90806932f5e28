#include "lab/editor/reshape.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "lab/editor/shape_json.hpp"

namespace flipside::lab {

namespace {

using std::numbers::pi;

bool is_place(const std::string& key) {
    constexpr std::string_view keys[] = {"at", "a", "b", "center", "pivot", "position", "min", "max"};
    return std::ranges::find(keys, key) != std::end(keys);
}

using ChangePlace = std::function<Vec2(Vec2)>;

/// Calls `change` for every place in a thing, and what lies deeper in it.
void change_places(OrderedJson& thing, const ChangePlace& change) {
    for (auto& entry : thing.items()) {
        OrderedJson& value = entry.value();
        if (thing.is_object() && is_place(entry.key()))
            value = place_json(change(vector_of(value)));
        else if (thing.is_object() && entry.key() == "points")
            for (OrderedJson& point : value) point = place_json(change(vector_of(point)));
        else if (value.is_structured())
            change_places(value, change);
    }
}

/// Angles that belong together stay within a turn of the first.
void turn_angles(OrderedJson& thing, double by) {
    if (!thing.is_structured()) return;
    const auto turn = [by](double degrees) { return degrees + by * 180 / pi; };
    const auto whole_turns = [](double degrees) { return 360 * std::floor((degrees + 180) / 360); };
    for (const char* key : {"from_deg", "rest_deg", "direction_deg"}) {
        if (!thing.is_object() || !thing.contains(key)) continue;
        const double first = turn(thing[key].get<double>()), back = whole_turns(first);
        thing[key] = number(to_nine_digits(first - back));
        if (thing.contains("to_deg"))
            thing["to_deg"] = number(to_nine_digits(turn(thing["to_deg"].get<double>()) - back));
    }
    for (auto& entry : thing.items()) {
        if (thing.is_object() && (entry.key() == "normal" || entry.key() == "velocity"))
            entry.value() = place_json(rotated(vector_of(entry.value()), by));
        else
            turn_angles(entry.value(), by);
    }
}

}  // namespace

OrderedJson moved(const OrderedJson& thing, Vec2 by) {
    OrderedJson result = thing;
    change_places(result, [by](Vec2 place) { return place + by; });
    return result;
}

OrderedJson turned(const OrderedJson& thing, Vec2 about, double angle) {
    OrderedJson result = thing;
    change_places(result, [&](Vec2 place) { return about + rotated(place - about, angle); });
    turn_angles(result, angle);
    if (!result.contains("motion") || !result["motion"].contains("raised_deg")) return result;
    // The way from rest to raised stays as long as it was.
    const double way = value_of(thing.at("motion"), "raised_deg") - value_of(thing.at("shape"), "rest_deg");
    result["motion"]["raised_deg"] = number(to_nine_digits(value_of(result.at("shape"), "rest_deg") + way));
    return result;
}

std::vector<Vec2> joints_of(const OrderedJson& thing) {
    const OrderedJson& shape = shape_in(thing);
    const std::string type = type_of(shape);
    if (type == "arc")
        return {arc_point(shape, angle_in(shape, "from_deg")), arc_point(shape, angle_in(shape, "to_deg"))};
    std::vector<Vec2> joints;
    if (type == "compound")
        for (const OrderedJson& member : shape.at("of"))
            for (const Vec2 joint : joints_of(member)) joints.push_back(joint);
    if (type == "capsule") return joints;
    if (!thing.contains("min")) return corners_of(shape).empty() ? joints : corners_of(shape);
    const Vec2 min = vector_of(thing.at("min")), max = vector_of(thing.at("max"));
    return {min, {max.x, min.y}, max, {min.x, max.y}};
}

Vec2 middle_of(const OrderedJson& thing) {
    if (thing.contains("motion") && thing.at("motion").contains("pivot"))
        return vector_of(thing.at("motion").at("pivot"));
    const OrderedJson& shape = shape_in(thing);
    for (const char* key : {"pivot", "center", "position"})
        if (shape.contains(key)) return vector_of(shape.at(key));
    std::optional<Box> box;
    OrderedJson places = shape;
    change_places(places, [&](Vec2 p) {
        box = box ? Box{{std::min(box->min.x, p.x), std::min(box->min.y, p.y)},
                        {std::max(box->max.x, p.x), std::max(box->max.y, p.y)}}
                  : Box{p, p};
        return p;
    });
    return box ? 0.5 * (box->min + box->max) : Vec2{};
}

std::optional<double> direction_of(const OrderedJson& thing) {
    const OrderedJson& shape = shape_in(thing);
    const std::string type = type_of(shape);
    if (type == "flipper") return angle_in(shape, "rest_deg");
    if (type == "arc") return angle_in(shape, "from_deg");
    if (thing.contains("direction_deg")) return angle_in(thing, "direction_deg");
    const std::vector<Vec2> corners = corners_of(shape);
    if (corners.size() < 2 || thing.contains("min")) return std::nullopt;
    return angle_of(corners[1] - corners[0]);
}

}  // namespace flipside::lab

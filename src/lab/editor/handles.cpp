#include "lab/editor/handles.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lab/editor/reshape.hpp"
#include "lab/editor/shape_json.hpp"
#include "world/math.hpp"
#include "world/surface.hpp"

namespace flipside::lab {

namespace {

using std::numbers::pi;

constexpr double whole = 359.9;  ///< degrees of an arc that is taken for a circle

/// The arc from a to b that turns by `sweep` rad, 0 < sweep < 2π.
void set_arc(OrderedJson& arc, Vec2 a, Vec2 b, double sweep) {
    const Vec2 chord = b - a;
    const double half = 0.5 * sweep;
    // From the middle of the chord to the left of it, as far as the centre is.
    const Vec2 center = 0.5 * (a + b) + 0.5 * math::cos(half) / math::sin(half) * perp(chord);
    const double from = angle_of(a - center);
    arc["center"] = place_json(center);
    arc["radius"] = length_json(length(a - center));
    arc["from_deg"] = degrees_json(from);
    arc["to_deg"] = degrees_json(from + sweep);
}

bool is_end(const Handle& handle) {
    return handle.role == Role::corner || handle.role == Role::arc_end;
}

bool lie_together(const Handle& a, const Handle& b) {
    return length(a.at - b.at) <= joint_distance;
}

void append_corners(const OrderedJson& shape, std::vector<Handle>& handles) {
    const std::vector<Vec2> corners = corners_of(shape);
    const std::size_t n = corners.size();
    for (std::size_t i = 0; i < n; ++i) {
        Handle handle{Role::corner, i, corners[i]};
        if (n > 1) handle.anchor = corners[i > 0 ? i - 1 : 1];
        handles.push_back(handle);
    }
    if (!shape.contains("points")) return;
    for (std::size_t i = 0; i + (is_closed(shape) ? 0 : 1) < n; ++i)
        handles.push_back({Role::between, i, 0.5 * (corners[i] + corners[(i + 1) % n])});
}

void append_arc(const OrderedJson& arc, std::vector<Handle>& handles) {
    const double from = angle_in(arc, "from_deg"), to = angle_in(arc, "to_deg");
    const Vec2 a = arc_point(arc, from), b = arc_point(arc, to);
    handles.push_back({Role::centre, 0, vector_of(arc.at("center"))});
    handles.push_back({Role::arc_bulge, 0, arc_point(arc, 0.5 * (from + to))});
    handles.push_back({Role::arc_end, 0, a, b});
    handles.push_back({Role::arc_end, 1, b, a});
}

void append_flipper(const OrderedJson& thing, const OrderedJson& flipper, std::vector<Handle>& handles) {
    const Vec2 pivot = vector_of(flipper.at("pivot"));
    const double far = value_of(flipper, "length");
    handles.push_back({Role::centre, 0, pivot});
    handles.push_back({Role::tip, 0, pivot + far * from_angle(angle_in(flipper, "rest_deg")), pivot});
    if (thing.contains("motion") && thing.at("motion").contains("raised_deg"))
        handles.push_back(
            {Role::raised, 0, pivot + far * from_angle(angle_in(thing.at("motion"), "raised_deg")), pivot});
}

/// Where the radius of a capsule is pulled: beside its middle.
Vec2 beside_capsule(const OrderedJson& capsule) {
    const Vec2 a = vector_of(capsule.at("a")), b = vector_of(capsule.at("b"));
    return 0.5 * (a + b) + value_of(capsule, "radius") * perp(unit(b - a));
}

void pull_corner(OrderedJson& shape, std::size_t index, Vec2 to) {
    if (shape.contains("points")) {
        shape["points"][index] = place_json(to);
        return;
    }
    std::size_t i = 0;
    for (const char* key : {"at", "a", "b", "min", "max"})
        if (shape.contains(key) && i++ == index) shape[key] = place_json(to);
    // The way through a gate stays on its side.
    if (type_of(shape) == "gate") {
        const Vec2 across = perp(unit(vector_of(shape["b"]) - vector_of(shape["a"])));
        const bool left = dot(vector_of(shape["normal"]), across) >= 0;
        shape["normal"] = place_json(left ? across : -across);
    }
}

void pull_arc_end(OrderedJson& arc, std::size_t end, Vec2 to) {
    const double from = angle_in(arc, "from_deg"), sweep = angle_in(arc, "to_deg") - from;
    const Vec2 center = vector_of(arc.at("center"));
    if (sweep > whole * pi / 180) {  // its ends are one: they go round together
        const double turned_to = angle_of(to - center);
        arc["radius"] = length_json(length(to - center));
        arc["from_deg"] = degrees_json(turned_to);
        arc["to_deg"] = degrees_json(turned_to + sweep);
        return;
    }
    const Vec2 other = arc_point(arc, end == 0 ? from + sweep : from);
    if (length(to - other) < least_radius) return;
    set_arc(arc, end == 0 ? to : other, end == 0 ? other : to, sweep);
}

/// Through both ends and, in the middle between them, as far out as `to` is.
void pull_bulge(OrderedJson& arc, Vec2 to) {
    const double from = angle_in(arc, "from_deg"), sweep = angle_in(arc, "to_deg") - from;
    const Vec2 center = vector_of(arc.at("center"));
    if (sweep > whole * pi / 180) {
        arc["radius"] = length_json(length(to - center));
        return;
    }
    const Vec2 a = arc_point(arc, from), b = arc_point(arc, from + sweep);
    // Height over the chord, to its right; four times the half angle's tangent is the sweep.
    const double height = dot(to - 0.5 * (a + b), -perp(unit(b - a)));
    const double wanted = 4 * math::atan2(height, 0.5 * length(b - a));
    constexpr double least = pi / 180;
    if (wanted >= 0) return set_arc(arc, a, b, std::clamp(wanted, least, 2 * pi - least));
    set_arc(arc, b, a, std::clamp(-wanted, least, 2 * pi - least));  // it bulges to the other side
}

void pull_tip(OrderedJson& flipper, Vec2 to) {
    const Vec2 way = to - vector_of(flipper.at("pivot"));
    const double least =
        std::abs(value_of(flipper, "base_radius") - value_of(flipper, "tip_radius")) + least_radius;
    flipper["length"] = length_json(std::max(least, length(way)));
    flipper["rest_deg"] = degrees_json(angle_of(way));
}

void pull_raised(OrderedJson& thing, Vec2 to) {
    const OrderedJson& flipper = thing.at("shape");
    const double rest = value_of(flipper, "rest_deg");
    const double raised = angle_of(to - vector_of(flipper.at("pivot"))) * 180 / pi;
    // The shorter way round.
    thing["motion"]["raised_deg"] = number(to_nine_digits(rest + std::remainder(raised - rest, 360.0)));
}

void pull_velocity(OrderedJson& ball, Vec2 to) {
    const Vec2 way = to - vector_of(ball.at("position"));
    const double far = std::max(0.0, length(way) - arrow_begin(ball));
    ball["velocity"] = place_json(far / velocity_seconds * unit(way));
}

void insert_corner(OrderedJson& shape, std::size_t after, Vec2 to) {
    OrderedJson& points = shape["points"];
    points.insert(points.begin() + static_cast<std::ptrdiff_t>(after) + 1, place_json(to));
}

void pull_radius(OrderedJson& thing, Vec2 to) {
    OrderedJson& shape = shape_in(thing);
    double radius = 0;
    if (type_of(shape) == "capsule") {
        const Vec2 a = vector_of(shape.at("a")), b = vector_of(shape.at("b"));
        radius = std::abs(dot(to - a, perp(unit(b - a))));
    } else {
        radius = length(to - vector_of(shape.at(shape.contains("center") ? "center" : "position")));
    }
    shape["radius"] = length_json(radius);
}

/// Of the shapes of a compound, but not of compounds among them. Of ends that lie together one is enough.
void append_members(const OrderedJson& members, std::vector<Handle>& handles) {
    for (std::size_t i = 0; i < members.size(); ++i)
        for (Handle handle : handles_of(members[i])) {
            const bool seen = is_end(handle) && std::ranges::any_of(handles, [&](const Handle& other) {
                                  return is_end(other) && lie_together(other, handle);
                              });
            handle.member = i;
            if (!seen && type_of(members[i]) != "compound") handles.push_back(handle);
        }
}

OrderedJson pulled_member(const OrderedJson& thing, const Handle& handle, Vec2 to) {
    OrderedJson result = thing;
    OrderedJson& members = shape_in(result)["of"];
    for (std::size_t i = 0; i < members.size(); ++i)
        for (Handle own : handles_of(members[i])) {
            const bool same = own.is(handle.role, handle.index) && i == *handle.member;
            if (!same && !(is_end(handle) && is_end(own) && lie_together(own, handle))) continue;
            own.member.reset();
            members[i] = pulled(members[i], own, to);
            break;
        }
    return result;
}

}  // namespace

double arrow_begin(const OrderedJson& ball) {
    return 2 * ball.at("radius").get<double>();
}

std::vector<Handle> handles_of(const OrderedJson& thing) {
    std::vector<Handle> handles;
    const OrderedJson& shape = shape_in(thing);
    const std::string type = type_of(shape);
    if (thing.contains("position")) {
        const Vec2 at = vector_of(thing.at("position"));
        handles.push_back({Role::centre, 0, at});
        if (thing.contains("direction_deg"))
            handles.push_back(
                {Role::direction, 0,
                 at + 4 * value_of(thing.at("ball"), "radius") * from_angle(angle_in(thing, "direction_deg")),
                 at});
        if (thing.contains("radius")) {
            handles.push_back({Role::radius, 0, at + Vec2{value_of(thing, "radius"), 0}, at});
            const Vec2 velocity = thing.contains("velocity") ? vector_of(thing.at("velocity")) : Vec2{};
            handles.push_back({Role::velocity, 0,
                               at + velocity_seconds * velocity + arrow_begin(thing) * unit(velocity), at});
        }
    } else if (type == "arc") {
        append_arc(shape, handles);
    } else if (type == "circle") {
        const Vec2 center = vector_of(shape.at("center"));
        handles.push_back({Role::centre, 0, center});
        handles.push_back({Role::radius, 0, center + Vec2{value_of(shape, "radius"), 0}, center});
    } else if (type == "flipper") {
        append_flipper(thing, shape, handles);
    } else if (type == "compound") {
        append_members(shape.at("of"), handles);
    } else {
        append_corners(shape, handles);
        if (type == "capsule") {
            const Vec2 middle = 0.5 * (vector_of(shape.at("a")) + vector_of(shape.at("b")));
            handles.push_back({Role::radius, 0, beside_capsule(shape), middle});
        }
    }
    if (thing.contains("motion") && thing.at("motion").contains("pivot"))
        handles.push_back({Role::pivot, 0, vector_of(thing.at("motion").at("pivot"))});
    return handles;
}

OrderedJson pulled(const OrderedJson& thing, const Handle& handle, Vec2 to) {
    if (handle.member) return pulled_member(thing, handle, to);
    OrderedJson result = thing;
    OrderedJson& shape = shape_in(result);
    switch (handle.role) {
        case Role::corner:
            pull_corner(shape, handle.index, to);
            break;
        case Role::between:
            insert_corner(shape, handle.index, to);
            break;
        case Role::centre:
            return moved(thing, to - handle.at);
        case Role::radius:
            pull_radius(result, to);
            break;
        case Role::arc_end:
            pull_arc_end(shape, handle.index, to);
            break;
        case Role::arc_bulge:
            pull_bulge(shape, to);
            break;
        case Role::tip:
            pull_tip(shape, to);
            break;
        case Role::raised:
            pull_raised(result, to);
            break;
        case Role::pivot:
            result["motion"]["pivot"] = place_json(to);
            break;
        case Role::velocity:
            pull_velocity(result, to);
            break;
        case Role::direction:
            result["direction_deg"] = degrees_json(angle_of(to - vector_of(result.at("position"))));
            break;
    }
    return result;
}

OrderedJson with_whole_sweep(const OrderedJson& thing, const Handle& handle, double degrees) {
    OrderedJson result = thing;
    OrderedJson& shape = shape_in(result);
    OrderedJson& arc = handle.member ? shape["of"][*handle.member] : shape;
    const double from = angle_in(arc, "from_deg"), to = angle_in(arc, "to_deg");
    if (to - from > whole * pi / 180) return result;
    const double unit = degrees * pi / 180;
    const double sweep = unit * std::clamp(std::round((to - from) / unit), 1.0, std::ceil(2 * pi / unit) - 1);
    set_arc(arc, arc_point(arc, from), arc_point(arc, to), sweep);
    return result;
}

OrderedJson without_corner(const OrderedJson& thing, std::size_t corner) {
    OrderedJson result = thing;
    OrderedJson& shape = shape_in(result);
    if (!shape.contains("points") || shape["points"].size() <= (is_closed(shape) ? 3U : 2U)) return result;
    shape["points"].erase(corner);
    return result;
}

}  // namespace flipside::lab

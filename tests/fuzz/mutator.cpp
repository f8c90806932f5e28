#include "fuzz/mutator.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flipside::fuzz {

namespace {

using Json = nlohmann::json;

/// Numbers at which comparisons, products and conversions change what they do. Those with a name of their own
/// in the code: joint_distance 1e-6, touch_distance 1e-4, the limits of the schemas.
constexpr double special[] = {0.0,
                              -0.0,
                              1,
                              -1,
                              0.5,
                              2,
                              1e-3,
                              1e-4,
                              1e-6,
                              1e-9,
                              1e-12,
                              -1e-12,
                              1e-15,
                              1e-16,
                              2.2250738585072014e-308,
                              5e-324,
                              -5e-324,
                              1.0 / 60,
                              45,
                              90,
                              180,
                              360,
                              100,
                              1e3,
                              1e6,
                              1e9,
                              -1e9,
                              1e12,
                              1e15,
                              9007199254740992,
                              9007199254740994,
                              1e16,
                              1e18,
                              9223372036854775808.0,
                              18446744073709551616.0,
                              2147483647,
                              2147483648,
                              4294967294,
                              4294967295,
                              4294967296,
                              1e30,
                              1e154,
                              1e200,
                              1.7976931348623157e308,
                              -1.7976931348623157e308};

void collect(Json& value, auto& values) {
    values.all.push_back(&value);
    if (value.is_number()) values.numbers.push_back(&value);
    if (!value.is_structured()) return;
    if (!value.empty()) values.containers.push_back(&value);
    if (value.is_array() && value.size() == 2 && value[0].is_number() && value[1].is_number())
        values.points.push_back(&value);
    for (Json& member : value) collect(member, values);
}

/// Whole numbers stay whole, so that counts and indices are still read.
Json as_json(double number, bool whole) {
    if (whole && std::abs(number) < 9e15 && number == std::floor(number))
        return static_cast<std::int64_t>(number);
    return std::isfinite(number) ? Json(number) : Json(0.0);
}

}  // namespace

std::string Mutator::mutate(std::string_view text) {
    if (below(16) == 0) return {};
    Json document = Json::parse(text, nullptr, /*allow_exceptions=*/false);
    if (document.is_discarded()) return change_table(text);
    if (!document.is_structured()) return {};
    for (std::size_t changes = 1 + below(3); changes > 0; --changes) change(document);
    return document.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string Mutator::cross(std::string_view first, std::string_view second) {
    Json document = Json::parse(first, nullptr, false), other = Json::parse(second, nullptr, false);
    if (!document.is_structured() || !other.is_structured()) return {};
    Values values, others;
    collect(document, values);
    collect(other, others);
    if (values.containers.empty() || others.containers.empty()) return {};
    Json& from = *any_of(others.containers);
    Json& to = *any_of(values.containers);
    if (from.is_object() && to.is_object()) {
        const auto member = std::next(from.begin(), static_cast<std::ptrdiff_t>(below(from.size())));
        to[member.key()] = member.value();
    } else if (from.is_array() && to.is_array()) {
        to.push_back(from[below(from.size())]);
    } else {
        to = Json(from);
    }
    return document.dump(-1, ' ', false, Json::error_handler_t::replace);
}

void Mutator::change(Json& document) {
    Values values;
    collect(document, values);
    const std::size_t what = below(16);
    if (what < 9 && !values.numbers.empty()) {
        change_number(*any_of(values.numbers), values);
    } else if (what < 12 && values.points.size() > 1) {
        move_to_touch(document, values);
    } else if (what == 12) {
        Json copy = *any_of(values.all);
        *any_of(values.all) = std::move(copy);
    } else if (!values.containers.empty()) {
        change_container(*any_of(values.containers), values);
    }
}

/// A few representable numbers, or a relative 1e-16 to 1e-3, beside it.
double Mutator::near(double value) {
    if (below(2) == 0) {
        const double towards = below(2) == 0 ? HUGE_VAL : -HUGE_VAL;
        for (std::size_t steps = 1 + below(4); steps > 0; --steps) value = std::nextafter(value, towards);
        return value;
    }
    const double relative = std::pow(10.0, -3.0 - static_cast<double>(below(14)));
    return value * (below(2) == 0 ? 1 + relative : 1 - relative);
}

void Mutator::change_number(Json& number, const Values& values) {
    const double old = number.get<double>();
    const double other = any_of(values.numbers)->get<double>();
    const double third = any_of(values.numbers)->get<double>();
    const bool whole = number.is_number_integer();
    double changed = old;
    switch (below(12)) {
        case 0:
            changed = special[below(std::size(special))];
            break;
        case 1:
            changed = -old;
            break;
        case 2:
            changed = near(old);
            break;
        case 3:
            changed = other;
            break;
        case 4:
            changed = near(other);
            break;
        case 5:
            changed = other + third;
            break;
        case 6:
            changed = other - third;
            break;
        case 7:
            changed = (other + third) / 2;
            break;
        case 8:
            changed = old * std::pow(10.0, static_cast<double>(below(13)) - 6);
            break;
        case 9:
            changed = old + (whole ? 1 : 0.01) * (static_cast<double>(below(21)) - 10);
            break;
        case 10:
            changed = static_cast<double>(below(2001)) / 1000 - 1;
            break;
        default:
            changed = std::round(old * 100) / 100;
            break;
    }
    number = as_json(changed, whole && below(8) != 0);
}

/// Puts a point where its owner just touches another one, or exactly onto it.
void Mutator::move_to_touch(Json& document, const Values& values) {
    std::vector<double> lengths{0};
    const Json flat = document.flatten();
    for (const auto& [path, value] : flat.items())
        if (path.ends_with("radius") && value.is_number()) lengths.push_back(value.get<double>());
    Json& point = *any_of(values.points);
    const Json& from = *any_of(values.points);
    const Json& to = *any_of(values.points);
    const double share = static_cast<double>(below(3)) / 2;
    double at[2], distance = any_of(lengths) + (below(2) == 0 ? 0 : any_of(lengths));
    for (std::size_t i = 0; i < 2; ++i)
        at[i] = from[i].get<double>() + share * (to[i].get<double>() - from[i].get<double>());
    if (below(4) == 0) distance = near(distance);
    constexpr double turns[] = {0, 0.25, 0.5, 0.75, 0.125, 0.1, 1.0 / 3};
    const double angle = 2 * 3.14159265358979323846 * turns[below(std::size(turns))];
    // Along an axis exactly, without the rounding of cos(π/2).
    const bool upright = angle == 2 * 3.14159265358979323846 * 0.25;
    at[0] += upright ? 0 : distance * std::cos(angle);
    at[1] += upright ? distance : distance * std::sin(angle);
    for (std::size_t i = 0; i < 2; ++i) point[i] = as_json(at[i], false);
}

void Mutator::change_container(Json& container, const Values& values) {
    if (container.is_array())
        change_array(container, values);
    else
        change_object(container, values);
}

void Mutator::change_array(Json& array, const Values& /*values*/) {
    const std::size_t i = below(array.size()), j = below(array.size());
    switch (below(4)) {
        case 0:
            array.insert(array.begin() + static_cast<std::ptrdiff_t>(i), Json(array[j]));
            break;
        case 1:
            array.push_back(Json(array[i]));
            break;
        case 2:
            array.erase(i);
            break;
        default:
            std::swap(array[i], array[j]);
            break;
    }
}

void Mutator::change_object(Json& object, const Values& values) {
    const auto member = std::next(object.begin(), static_cast<std::ptrdiff_t>(below(object.size())));
    const std::string& key = member.key();
    const Json& other = *any_of(values.containers);
    const std::size_t what = below(16);
    if (member->is_boolean()) {
        *member = !member->get<bool>();
    } else if (what == 0) {
        object.erase(member);
    } else if (what == 1 && other.is_object()) {
        const auto from = std::next(other.begin(), static_cast<std::ptrdiff_t>(below(other.size())));
        Json copy = from.value();
        object[from.key()] = std::move(copy);
    } else {
        // Another object's value of the same key: another shape, another motion, another layer.
        std::vector<const Json*> same_key;
        for (const Json* container : values.containers)
            if (container->is_object() && container->contains(key)) same_key.push_back(&(*container)[key]);
        *member = Json(*any_of(same_key));
    }
}

/// Lines of fields: a field becomes another one or a special number, a line is repeated, left out or swapped.
std::string Mutator::change_table(std::string_view text) {
    std::vector<std::vector<std::string>> lines(1, std::vector<std::string>(1));
    for (const char c : text) {
        if (c == '\n')
            lines.emplace_back(1);
        else if (c == ',')
            lines.back().emplace_back();
        else
            lines.back().back() += c;
    }
    auto& line = any_of(lines);
    std::string& field = any_of(line);
    switch (below(6)) {
        case 0:
            field = any_of(any_of(lines));
            break;
        case 1:
            field = Json(special[below(std::size(special))]).dump();
            break;
        case 2:
            field = below(2) == 0 ? "nan" : "-inf";
            break;
        case 3:
            lines.push_back(line);
            break;
        case 4:
            std::swap(line, any_of(lines));
            break;
        default:
            return {};
    }
    std::string changed;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (i > 0) changed += '\n';
        for (std::size_t k = 0; k < lines[i].size(); ++k) changed += (k > 0 ? "," : "") + lines[i][k];
    }
    return changed;
}

}  // namespace flipside::fuzz

#include "lab/report/figure.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "lab/files/csv.hpp"
#include "lab/files/whole_file.hpp"

namespace flipside::lab::report {

namespace {

/// Steps of 1, 2 or 5 times a power of ten, about five across the range.
double round_step(double span) {
    const double power = std::pow(10, std::floor(std::log10(span / 5)));
    const double rest = span / 5 / power;
    return power * (rest > 5 ? 10 : rest > 2 ? 5 : rest > 1 ? 2 : 1);
}

constexpr double margin = 0.02;  ///< of the span, at either end

Range rounded(Range range, const Axis& axis) {
    if (axis.logarithmic) {
        const double from = std::floor(std::log10(range.from));
        const double to = std::max(std::ceil(std::log10(range.to)), from + 1), more = margin * (to - from);
        return {std::pow(10, from - more), std::pow(10, to + more)};
    }
    const double step = round_step(range.to > range.from ? range.to - range.from : 1);
    const double from = step * std::floor(range.from / step);
    const double to = std::max(step * std::ceil(range.to / step), from + step), more = margin * (to - from);
    return {from - more, to + more};
}

using Coordinate = double Point::*;

Range range_of(const Figure& figure, const Axis& axis, Coordinate coordinate) {
    if (!axis.things.empty()) return {0.4, static_cast<double>(axis.things.size()) + 0.6};
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Range range{infinity, -infinity};
    for (const Series& series : figure.series) {
        for (const Point& point : series.points) {
            double value = point.*coordinate;
            if (!std::isfinite(value)) continue;
            if (axis.logarithmic) {
                value = std::max(value, axis.floor);
                if (value <= 0) continue;
            }
            range = {std::min(range.from, value), std::max(range.to, value)};
        }
    }
    if (range.from > range.to) range = {1, 1};
    return rounded(range, axis);
}

/// gnuplot reads line by line, quotes or not.
std::string in_one_line(const std::string& text) {
    std::string line;
    for (const char c : text) line += c == '\n' ? std::string("; ") : std::string(1, c);
    return line;
}

}  // namespace

Frame frame_of(const Figure& figure) {
    return {range_of(figure, figure.x, &Point::x), range_of(figure, figure.y, &Point::y)};
}

std::vector<std::pair<const Series*, const Point*>> rows_of(const Figure& figure) {
    std::vector<std::pair<const Series*, const Point*>> rows;
    for (const Series& series : figure.series)
        for (const bool failed : {false, true})
            for (const Point& point : series.points)
                if (std::isinf(point.y) == failed) rows.emplace_back(&series, &point);
    return rows;
}

void write_csv(const Figure& figure, const std::filesystem::path& file) {
    WholeFile csv(file);
    CsvRow row;
    row.add("series").add(figure.x.column).add(figure.y.column).add("point").write(csv.out());
    for (const auto& [series, point] : rows_of(figure))
        row.add(series->name).add(point->x).add(point->y).add(in_one_line(point->says)).write(csv.out());
    csv.finish();
}

std::string short_number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.4g", value);
    return text;
}

std::string rounded_text(double value, int digits) {
    if (!(std::abs(value) < 1e15)) return short_number(value);
    if (value != 0) {
        const double unit = std::pow(10, std::floor(std::log10(std::abs(value))) - digits + 1);
        value = std::round(value / unit) * unit;
    }
    if (std::abs(value) < 1000) return short_number(value);
    std::string text = std::to_string(std::llround(value));
    for (auto at = static_cast<std::ptrdiff_t>(text.size()) - 3; at > (value < 0 ? 1 : 0); at -= 3)
        text.insert(static_cast<std::size_t>(at), ",");
    return text;
}

std::string step_text(double dt) {
    const double per_second = std::round(1 / dt);
    return std::abs(per_second * dt - 1) < 1e-9 ? "1/" + short_number(per_second) + " s"
                                                : short_number(dt) + " s";
}

std::string time_text(double seconds) {
    struct Unit {
        double seconds;
        const char* name;
    };
    for (const Unit unit : {Unit{1, "s"}, Unit{1e-3, "ms"}, Unit{1e-6, "µs"}})
        if (seconds >= 0.9995 * unit.seconds)
            return rounded_text(seconds / unit.seconds, 3) + " " + unit.name;
    return rounded_text(seconds / 1e-9, 3) + " ns";
}

std::string times_text(double ratio) {
    return rounded_text(ratio) + (ratio == 1 ? " time" : " times");
}

}  // namespace flipside::lab::report

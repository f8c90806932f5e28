#include "app/window/plot.hpp"

#include <algorithm>
#include <cmath>

#include "app/window/words.hpp"

namespace flipside::app {

std::vector<std::vector<Sample>> unbroken(std::span<const Sample> samples, double from, double to,
                                          double gap) {
    std::vector<std::vector<Sample>> runs;
    bool broken = true;
    for (const Sample& sample : samples) {
        if (sample.time < from || sample.time > to || !std::isfinite(sample.value)) {
            broken = true;
            continue;
        }
        if (broken || sample.time - runs.back().back().time > gap) runs.emplace_back();
        runs.back().push_back(sample);
        broken = false;
    }
    return runs;
}

std::vector<double> round_ticks(double low, double high, int most) {
    if (!(high > low)) return {};
    double step = std::pow(10, std::floor(std::log10((high - low) / most)));
    const auto count = [&](double each) { return std::floor(high / each) - std::ceil(low / each) + 1; };
    constexpr double steps[] = {1, 2, 5, 10, 20};
    const double* fitting = std::ranges::find_if(steps, [&](double k) { return count(k * step) <= most; });
    step *= fitting == std::end(steps) ? 50 : *fitting;
    std::vector<double> ticks;
    const auto first = static_cast<long long>(std::ceil(low / step));
    const auto last = static_cast<long long>(std::floor(high / step));
    for (long long i = first; i <= last; ++i) ticks.push_back(static_cast<double>(i) * step);
    return ticks;
}

void fit(Plot& plot, double from, double to) {
    double low = 0, high = 0;
    bool any = false;
    for (const Curve& curve : plot.curves)
        for (const Sample& sample : curve.samples) {
            if (sample.time < from || sample.time > to || !std::isfinite(sample.value)) continue;
            low = any ? std::min(low, sample.value) : sample.value;
            high = any ? std::max(high, sample.value) : sample.value;
            any = true;
        }
    if (low > 0 && low < 0.5 * high) low = 0;
    if (low == 0 && high == 0) high = 1;  // a range that says that there is nothing
    const double span = std::max(high - low, 1e-9 + 0.02 * std::max(std::abs(high), std::abs(low)));
    plot.bottom = low == 0 ? 0 : 0.5 * (low + high) - 0.55 * span;
    plot.top = 0.5 * (low + high) + 0.55 * span;
}

TimeSpan span_until(double now) {
    constexpr double least = 0.5;
    return {std::max(0.0, now - history_seconds), std::max(now, least)};
}

namespace {

struct Axes {
    Rect box;  ///< px
    Plot const& plot;
    TimeSpan time;

    [[nodiscard]] double x(double at) const {
        return box.x + (at - time.from) / (time.to - time.from) * box.width;
    }
    [[nodiscard]] double time_at(double px) const {
        return time.from + (px - box.x) / box.width * (time.to - time.from);
    }
    [[nodiscard]] double y(double value) const {
        const bool decades = plot.scale == Scale::decades;
        const auto f = [&](double v) { return decades ? std::log10(std::max(v, 1e-300)) : v; };
        const double share = (f(value) - f(plot.bottom)) / (f(plot.top) - f(plot.bottom));
        return box.y + (1 - std::clamp(share, 0.0, 1.0)) * box.height;
    }
};

void draw_curve(Canvas& canvas, const Axes& axes, const Curve& curve, double gap) {
    for (const auto& run : unbroken(curve.samples, axes.time.from, axes.time.to, gap)) {
        std::vector<Vec2> points;
        for (const Sample& sample : run) {
            const Vec2 next{axes.x(sample.time), axes.y(sample.value)};
            // One point per pixel is enough.
            if (points.empty() || next.x - points.back().x >= 1) points.push_back(next);
        }
        if (points.size() == 1) canvas.disc(points.front(), canvas.scaled(1), curve.color);
        if (points.size() > 1) canvas.stroke(points, false, canvas.scaled(1.6), curve.color);
    }
}

/// The value of a curve at a time, if it has one there.
const Sample* value_at(const Curve& curve, double time, double gap) {
    const auto after = std::ranges::upper_bound(curve.samples, time, {}, &Sample::time);
    if (after == curve.samples.begin()) return nullptr;
    const Sample& sample = *std::prev(after);
    return time - sample.time <= gap && std::isfinite(sample.value) ? &sample : nullptr;
}

/// Title, note and values of now, flush right; those for which there is no room are left out, the first ones
/// first.
void draw_title(Canvas& canvas, const Rect& place, const Plot& plot, const PlotTime& time) {
    const double margin = canvas.scaled(10), y = place.y + canvas.scaled(4);
    const auto width_of = [&](const std::string& words) {
        return canvas.lettering().width(words, Type::small);
    };
    struct Figure {
        std::string words;
        sf::Color color;
    };
    std::vector<Figure> figures;
    if (!plot.note.empty()) figures.push_back({plot.note, colour::text});
    for (const Curve& curve : plot.curves) {
        const Sample* value = value_at(curve, time.now + 1e-9, time.gap);
        figures.push_back(
            {(curve.named ? curve.name + ' ' : "") + (value ? curve.words(value->value) : "–"), curve.color});
    }
    // Wide enough that changing digits do not move the next one.
    const auto taken = [&](const Figure& figure) {
        return std::max(canvas.scaled(58), width_of(figure.words)) + canvas.scaled(8);
    };
    double room = place.width - 3 * margin - width_of(plot.title);
    for (const Figure& figure : figures) room -= taken(figure);
    const std::string title =
        canvas.lettering().cut(room >= 0 ? plot.title : plot.brief, Type::small, place.width - 2 * margin);
    canvas.text({place.x + margin, y}, title, Type::small, colour::quiet);
    const double left = place.x + 2 * margin + width_of(title);
    double right = place.x + place.width - margin;
    for (std::size_t i = figures.size(); i-- > 0;) {
        if (right - width_of(figures[i].words) < left) break;
        canvas.text({right, y}, figures[i].words, Type::small, figures[i].color, Align::right);
        right -= taken(figures[i]);
    }
}

/// A level line and what stands at its left end.
struct Level {
    double value;
    std::string words;
};

/// As many as have room.
std::vector<Level> levels_of(const Plot& plot, double height, double line) {
    std::vector<Level> levels;
    const int most = std::max(2, static_cast<int>(height / (1.3 * line)));
    if (plot.scale == Scale::linear) {
        for (const double value : round_ticks(plot.bottom, plot.top, most))
            levels.push_back({value, plot.curves.empty() ? "" : plot.curves.front().words(value)});
        return levels;
    }
    const double low = std::log10(plot.bottom), high = std::log10(plot.top);
    for (const double exponent : round_ticks(low, high, most))
        if (exponent == std::round(exponent))
            levels.push_back(
                {std::pow(10, exponent), (exponent == 0 ? "1" : power_of_ten(static_cast<int>(exponent))) +
                                             (plot.curves.empty() ? "" : ' ' + plot.curves.front().unit)});
    return levels;
}

void draw_time(Canvas& canvas, const Axes& axes) {
    const int most = std::max(2, static_cast<int>(axes.box.width / canvas.scaled(70)));
    const std::vector<double> ticks = round_ticks(axes.time.from, axes.time.to, most);
    const auto whole = [](double value) { return std::abs(value - std::round(value)) < 1e-9; };
    int digits = 0;
    while (!std::ranges::all_of(ticks, [&](double tick) { return whole(tick * std::pow(10, digits)); }))
        ++digits;
    for (const double tick : ticks) {
        const double x = std::round(axes.x(tick));
        const std::string words = with_unit(tick, digits, "s");
        const double half = 0.5 * canvas.lettering().width(words, Type::small);
        canvas.line({x, axes.box.y + axes.box.height}, {x, axes.box.y + axes.box.height + canvas.scaled(3)},
                    1, colour::quiet);
        if (x - half < axes.box.x || x + half > axes.box.x + axes.box.width) continue;
        canvas.text({x, axes.box.y + axes.box.height + canvas.scaled(3)}, words, Type::small, colour::quiet,
                    Align::center);
    }
}

void draw_mark(Canvas& canvas, const Axes& axes, const Plot::Mark& mark, double gap) {
    const double x = std::round(axes.x(mark.time)), right = axes.box.x + axes.box.width;
    if (x < axes.box.x || x > right) return;
    if (mark.dot) {
        const Sample* value =
            axes.plot.curves.empty() ? nullptr : value_at(axes.plot.curves.front(), mark.time + gap, 2 * gap);
        canvas.disc({x, axes.y(value ? value->value : axes.plot.bottom)}, canvas.scaled(4), mark.color);
        return;
    }
    const double space = canvas.scaled(4);
    const double width = canvas.lettering().width(mark.words, Type::small) + space;
    canvas.line({x, axes.box.y}, {x, axes.box.y + axes.box.height}, canvas.scaled(1.2), mark.color);
    // Before the line where there is no room behind it; curves stay behind the words.
    const double left = x + width < right ? x + space : x - width;
    if (left < axes.box.x) return;
    // Above the ticks of impacts.
    const Vec2 corner{left, axes.box.y + axes.box.height - canvas.scaled(23)};
    canvas.rectangle(corner, corner + Vec2{width - space, canvas.scaled(17)},
                     with_alpha(colour::raised, 0.85));
    canvas.text(corner, mark.words, Type::small, mark.color);
}

/// A line through the moment under the mouse, and a box with every value there.
void draw_readout(Canvas& canvas, const Axes& axes, const PlotTime& time) {
    const Rect& box = axes.box;
    if (!box.contains(time.mouse.x, time.mouse.y)) return;
    const double at = axes.time_at(time.mouse.x);
    canvas.line({time.mouse.x, box.y}, {time.mouse.x, box.y + box.height}, 1, colour::quiet);
    const double line = canvas.lettering().line_height(Type::small), pad = canvas.scaled(5);
    std::vector<std::pair<std::string, sf::Color>> lines{{with_unit(at, 2, "s"), colour::text}};
    for (const Curve& curve : axes.plot.curves)
        if (const Sample* value = value_at(curve, at, time.gap))
            lines.emplace_back(curve.name + "  " + curve.words(value->value), curve.color);
    double width = 0;
    for (const auto& [words, color] : lines)
        width = std::max(width, canvas.lettering().width(words, Type::small));
    const double height = line * static_cast<double>(lines.size());
    const double left =
        std::clamp(time.mouse.x + 2 * pad, box.x, std::max(box.x, box.x + box.width - width - 2 * pad));
    const Vec2 corner{left, box.y + box.height - height - pad};
    canvas.rectangle(corner, corner + Vec2{width + 2 * pad, height + pad}, with_alpha(colour::around, 0.92));
    for (std::size_t i = 0; i < lines.size(); ++i)
        canvas.text(corner + Vec2{pad, 0.5 * pad + line * static_cast<double>(i)}, lines[i].first,
                    Type::small, lines[i].second);
}

}  // namespace

void draw_plot(Canvas& canvas, const Rect& place, const Plot& plot, const PlotTime& time) {
    canvas.rectangle({place.x, place.y}, {place.x + place.width, place.y + place.height}, colour::raised);
    draw_title(canvas, place, plot, time);
    const double margin = canvas.scaled(10), top = canvas.scaled(27), foot = canvas.scaled(21);
    const double line = canvas.lettering().line_height(Type::small);
    const double height = std::max(1.0, place.height - top - foot);
    const std::vector<Level> levels = levels_of(plot, height, line);
    double wide = 0;
    for (const Level& level : levels)
        wide = std::max(wide, canvas.lettering().width(level.words, Type::small) + canvas.scaled(6));
    if (2 * wide > place.width) wide = 0;  // the curves come before the words
    const Axes axes{
        {place.x + margin + wide, place.y + top, std::max(1.0, place.width - 2 * margin - wide), height},
        plot,
        span_until(time.now)};
    double free = place.y + place.height;
    for (const Level& level : levels) {
        const double y = std::round(axes.y(level.value));
        // Below the title, and none over the one below it.
        const double begin = std::max(y - 0.55 * line, place.y + canvas.scaled(4) + line);
        if (wide > 0 && begin + 0.9 * line <= free) {
            canvas.text({axes.box.x - canvas.scaled(6), begin}, level.words, Type::small, colour::quiet,
                        Align::right);
            free = begin;
        }
        canvas.line({axes.box.x, y}, {axes.box.x + axes.box.width, y}, 1, colour::rule);
    }
    draw_time(canvas, axes);
    for (const double impact : plot.impacts)
        if (impact >= axes.time.from && impact <= time.now) {
            const double x = std::round(axes.x(impact)), y = axes.box.y + axes.box.height;
            canvas.line({x, y - canvas.scaled(4)}, {x, y}, 1, with_alpha(colour::lit, 0.7));
        }
    for (const Curve& curve : plot.curves) draw_curve(canvas, axes, curve, time.gap);
    for (const Plot::Mark& mark : plot.marks) draw_mark(canvas, axes, mark, time.gap);
    draw_readout(canvas, axes, time);
}

}  // namespace flipside::app

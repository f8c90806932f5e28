#include "app/window/strip.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include "app/window/contender_colour.hpp"
#include "app/window/words.hpp"

namespace flipside::app {

namespace {

struct Axes {
    Rect place;                  ///< px, of the curves
    double now = 0;              ///< s, at the right edge
    double bottom = 0, top = 1;  ///< of the values

    [[nodiscard]] Vec2 at(double time, double value) const {
        const double x = 1 - (now - time) / history_seconds;
        const double y = (value - bottom) / (top - bottom);
        return {place.x + x * place.width, place.y + (1 - std::clamp(y, 0.0, 1.0)) * place.height};
    }
};

void curve(Canvas& canvas, const Axes& axes, const std::deque<Sample>& samples, sf::Color color,
           double (*of)(double)) {
    std::vector<Vec2> points;
    for (const Sample& sample : samples) {
        const Vec2 next = axes.at(sample.time, of(sample.value));
        // One point per pixel is enough.
        if (points.empty() || next.x - points.back().x >= 1) points.push_back(next);
    }
    canvas.stroke(points, false, canvas.scaled(1.6), color);
}

/// A value of now, in the colour of its curve.
struct Figure {
    std::string words;
    sf::Color color;
};

struct Title {
    std::string full, brief;  ///< the brief one where the values would not fit beside the full one
};

/// Title and values of now above, flush right; the box of the curves below. Values for which there is no room
/// are left out, the first ones first.
Rect frame(Canvas& canvas, const Rect& place, const Title& titles, const std::vector<Figure>& figures) {
    const double margin = canvas.scaled(12), top = canvas.scaled(26), y = place.y + canvas.scaled(5);
    const auto width_of = [&](const std::string& words) {
        return canvas.lettering().width(words, Type::small);
    };
    // Wide enough that changing digits do not move the next one.
    const auto taken = [&](const Figure& figure) {
        return std::max(canvas.scaled(62), width_of(figure.words)) + canvas.scaled(10);
    };
    canvas.rectangle({place.x, place.y}, {place.x + place.width, place.y + place.height}, colour::raised);
    double room = place.width - 3 * margin - width_of(titles.full);
    for (const Figure& figure : figures) room -= taken(figure);
    const std::string& title = room >= 0 ? titles.full : titles.brief;
    canvas.text({place.x + margin, y}, title, Type::small, colour::quiet);
    const double left = place.x + margin + width_of(title) + margin;
    double right = place.x + place.width - margin;
    for (std::size_t i = figures.size(); i-- > 0;) {
        if (right - width_of(figures[i].words) < left) break;
        canvas.text({right, y}, figures[i].words, Type::small, figures[i].color, Align::right);
        right -= taken(figures[i]);
    }
    return {place.x + margin, place.y + top, place.width - 2 * margin, place.height - top - canvas.scaled(8)};
}

/// A level line with its value written at the left end.
void level(Canvas& canvas, const Axes& axes, double value, const std::string& words) {
    const double y = std::round(axes.at(axes.now, value).y);
    const double width = canvas.lettering().width(words, Type::small) + canvas.scaled(6);
    canvas.text({axes.place.x, y - 0.55 * canvas.lettering().line_height(Type::small)}, words, Type::small,
                colour::quiet);
    canvas.line({axes.place.x + width, y}, {axes.place.x + axes.place.width, y}, 1, colour::rule);
}

sf::Color color_of(const Run& run) {
    return colour_of(run);
}

void draw_energy(Canvas& canvas, const Rect& place, const Stage& stage) {
    double low = 0, high = 0;
    bool any = false;
    for (const Run& run : stage.runs()) {
        for (const Sample& sample : run.energy_history()) {
            low = any ? std::min(low, sample.value) : sample.value;
            high = any ? std::max(high, sample.value) : sample.value;
            any = true;
        }
    }
    const double span = std::max(high - low, 1e-9 + 0.02 * std::max(std::abs(high), std::abs(low)));
    std::vector<Figure> figures;
    for (const Run& run : stage.runs()) figures.push_back({engineering(run.energy(), "J"), color_of(run)});
    const Axes axes{frame(canvas, place, {"Energy, last 12 s", "Energy"}, figures), stage.time(),
                    0.5 * (low + high) - 0.55 * span, 0.5 * (low + high) + 0.55 * span};
    if (low <= 0 && high >= 0) level(canvas, axes, 0, "0 J");
    for (const Run& run : stage.runs())
        curve(canvas, axes, run.energy_history(), color_of(run), [](double v) { return v; });
}

/// Of distances, in powers of ten of a radius.
constexpr double least = -13, most = 2;

double decades(double radii) {
    return std::log10(std::max(radii, 1e-30));
}

Axes distance_axes(Canvas& canvas, const Rect& place, const Stage& stage, const Title& title,
                   const std::vector<Figure>& figures) {
    const Axes axes{frame(canvas, place, title, figures), stage.time(), least, most};
    for (const int exponent : {-12, -6}) level(canvas, axes, exponent, power_of_ten(exponent) + " r");
    level(canvas, axes, 0, "1 r");
    return axes;
}

std::string distance_now(const Divergence& divergence, const Stage& stage) {
    const std::deque<Sample>& history = divergence.history();
    if (history.empty() || history.back().time < stage.time()) return "–";
    return in_radii(history.back().value);
}

bool with_reference(const Stage& stage, const Divergence& divergence) {
    return is_reference(stage.run_named(divergence.first()).engine()) ||
           is_reference(stage.run_named(divergence.second()).engine());
}

/// Two engines of which none is the measure of the other.
void draw_apart(Canvas& canvas, const Rect& place, const Stage& stage, const Divergence& divergence) {
    std::vector<Figure> figures;
    if (const auto& parting = divergence.parting())
        figures.push_back(
            {"parted at " + with_unit(parting->time, 2, "s") + " on " + divergence.parted_on(stage.scene()),
             colour::text});
    figures.push_back({distance_now(divergence, stage), colour::text});
    const Axes axes = distance_axes(canvas, place, stage, {"Apart, in radii", "Apart"}, figures);
    curve(canvas, axes, divergence.history(), colour::text, decades);
}

/// A moment of the past, named beside its line.
void moment(Canvas& canvas, const Axes& axes, double time, const std::string& words, sf::Color color) {
    const double x = std::round(axes.at(time, 0).x), right = axes.place.x + axes.place.width;
    if (x < axes.place.x) return;
    const double gap = canvas.scaled(4), width = canvas.lettering().width(words, Type::small) + gap;
    canvas.line({x, axes.place.y}, {x, axes.place.y + axes.place.height}, canvas.scaled(1.2), color);
    // Before the line where there is no room behind it; curves stay behind the words.
    const double left = x + width < right ? x + gap : x - width;
    const Vec2 corner{left, axes.place.y + axes.place.height - canvas.scaled(18)};
    canvas.rectangle(corner, corner + Vec2{width - gap, canvas.scaled(17)}, with_alpha(colour::raised, 0.85));
    canvas.text(corner, words, Type::small, color);
}

/// The other engines, each from the reference, and what the reference itself may be wrong by.
void draw_error(Canvas& canvas, const Rect& place, const Stage& stage, const Run& exact) {
    std::vector<const Divergence*> errors;
    std::vector<Figure> figures;
    const auto other = [&](const Divergence& divergence) {
        return color_of(
            stage.run_named(divergence.first() == exact.name() ? divergence.second() : divergence.first()));
    };
    for (const Divergence& divergence : stage.divergences()) {
        if (!divergence.is_of(exact.name())) continue;
        errors.push_back(&divergence);
        figures.push_back({distance_now(divergence, stage), other(divergence)});
    }
    const Axes axes = distance_axes(canvas, place, stage, {"From the reference", "Error"}, figures);
    curve(canvas, axes, exact.uncertainty_history(), color_of(exact), decades);
    for (const Divergence* divergence : errors)
        curve(canvas, axes, divergence->history(), other(*divergence), decades);
    if (const auto& halt = exact.halt())
        moment(canvas, axes, halt->time, "stopped", colour::warning);
    else if (const auto& time = exact.passed_horizon())
        moment(canvas, axes, *time, "horizon " + with_unit(*time, 2, "s"), color_of(exact));
}

}  // namespace

void draw_strip(Canvas& canvas, const Rect& place, const Stage& stage) {
    std::vector<std::function<void(const Rect&)>> plots;
    for (const Divergence& divergence : stage.divergences())
        if (!with_reference(stage, divergence))
            plots.emplace_back([&](const Rect& at) { draw_apart(canvas, at, stage, divergence); });
    for (const Run& run : stage.runs())
        if (is_reference(run.engine()) && stage.runs().size() > 1)
            plots.emplace_back([&](const Rect& at) { draw_error(canvas, at, stage, run); });
    plots.emplace_back([&](const Rect& at) { draw_energy(canvas, at, stage); });
    const double gap = canvas.scaled(6), count = static_cast<double>(plots.size());
    const double width = std::floor((place.width - (count - 1) * gap) / count);
    for (std::size_t i = 0; i < plots.size(); ++i)
        plots[i]({place.x + static_cast<double>(i) * (width + gap), place.y, width, place.height});
}

}  // namespace flipside::app

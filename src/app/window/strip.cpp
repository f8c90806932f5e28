#include "app/window/strip.hpp"

#include <algorithm>
#include <cmath>
#include <string>

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

/// Title and values of now above, flush right; the box of the curves below. Values for which there is no room
/// are left out, the first ones first.
Rect frame(Canvas& canvas, const Rect& place, const std::string& title, const std::vector<Figure>& figures) {
    const double margin = canvas.scaled(12), top = canvas.scaled(26), y = place.y + canvas.scaled(5);
    const auto width_of = [&](const std::string& words) {
        return canvas.lettering().width(words, Type::small);
    };
    canvas.rectangle({place.x, place.y}, {place.x + place.width, place.y + place.height}, colour::raised);
    canvas.text({place.x + margin, y}, title, Type::small, colour::quiet);
    const double left = place.x + margin + width_of(title) + margin;
    double right = place.x + place.width - margin;
    for (std::size_t i = figures.size(); i-- > 0;) {
        if (right - width_of(figures[i].words) < left) break;
        canvas.text({right, y}, figures[i].words, Type::small, figures[i].color, Align::right);
        // Wide enough that changing digits do not move the next one.
        right -= std::max(canvas.scaled(62), width_of(figures[i].words)) + canvas.scaled(10);
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
    return engine_colour(run.session().engine().name);
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
    const Axes axes{frame(canvas, place, "Energy, 12 s", figures), stage.time(),
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

Axes distance_axes(Canvas& canvas, const Rect& place, const Stage& stage, const std::string& title,
                   const std::vector<Figure>& figures) {
    const Axes axes{frame(canvas, place, title, figures), stage.time(), least, most};
    for (const int exponent : {-12, -6}) level(canvas, axes, exponent, power_of_ten(exponent) + " r");
    level(canvas, axes, 0, "1 r");
    return axes;
}

std::string distance_now(const Divergence& divergence, const Stage& stage) {
    const std::deque<Sample>& history = divergence.history();
    if (history.empty() || history.back().time < stage.time()) return "no ball in both";
    return in_radii(history.back().value);
}

/// The engines among each other.
void draw_apart(Canvas& canvas, const Rect& place, const Stage& stage, const Divergence& divergence) {
    std::string value = distance_now(divergence, stage);
    if (const auto& parting = divergence.parting())
        value = "parted at " + with_unit(parting->time, 2, "s") + " on " +
                divergence.parted_on(stage.scene()) + " · " + value;
    const Axes axes = distance_axes(canvas, place, stage, "Apart", {{value, colour::text}});
    curve(canvas, axes, divergence.history(), colour::text, decades);
}

}  // namespace

void draw_strip(Canvas& canvas, const Rect& place, const Stage& stage) {
    const std::vector<Divergence>& divergences = stage.divergences();
    const double gap = canvas.scaled(6);
    const auto plots = static_cast<double>(1 + divergences.size());
    const double width = std::floor((place.width - (plots - 1) * gap) / plots);
    double x = place.x;
    for (const Divergence& divergence : divergences) {
        draw_apart(canvas, {x, place.y, width, place.height}, stage, divergence);
        x += width + gap;
    }
    draw_energy(canvas, {x, place.y, place.x + place.width - x, place.height}, stage);
}

}  // namespace flipside::app

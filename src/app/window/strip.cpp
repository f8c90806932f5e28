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
        const double x = 1 - (now - time) / Run::history_seconds;
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

/// Title and current value above, the box of the curves below it.
Rect frame(Canvas& canvas, const Rect& place, const std::string& title, const std::string& value) {
    const double margin = canvas.scaled(12), top = canvas.scaled(26);
    canvas.rectangle({place.x, place.y}, {place.x + place.width, place.y + place.height}, colour::raised);
    canvas.text({place.x + margin, place.y + canvas.scaled(5)}, title, Type::small, colour::quiet);
    const double room = place.width - 2 * margin - canvas.lettering().width(title, Type::small) - margin;
    if (canvas.lettering().width(value, Type::small) < room)
        canvas.text({place.x + place.width - margin, place.y + canvas.scaled(5)}, value, Type::small,
                    colour::text, Align::right);
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
    const Axes axes{frame(canvas, place, "Energy, last 12 s", ""), stage.time(),
                    0.5 * (low + high) - 0.55 * span, 0.5 * (low + high) + 0.55 * span};
    if (low <= 0 && high >= 0) level(canvas, axes, 0, "0 J");
    double right = place.x + place.width - canvas.scaled(12);
    for (std::size_t i = stage.runs().size(); i-- > 0;) {
        const Run& run = stage.runs()[i];
        const std::string value = engineering(run.energy(), "J");
        canvas.text({right, place.y + canvas.scaled(5)}, value, Type::small,
                    engine_colour(run.session().engine().name), Align::right);
        right -=
            std::max(canvas.scaled(64), canvas.lettering().width(value, Type::small)) + canvas.scaled(10);
    }
    for (const Run& run : stage.runs())
        curve(canvas, axes, run.energy_history(), engine_colour(run.session().engine().name),
              [](double v) { return v; });
}

double decades(double metres) {
    return std::log10(std::max(metres, 1e-12));
}

void draw_distance(Canvas& canvas, const Rect& place, const Stage& stage) {
    const auto& history = stage.distance_history();
    std::string value = history.empty() || history.back().time < stage.time()
                            ? "no ball in both"
                            : engineering(history.back().value, "m") + " now";
    if (const auto& parting = stage.parting())
        value = "parted at " + with_unit(parting->time, 2, "s") +
                (parting->on.empty() ? "" : " on " + parting->on) + " · " + value;
    const Axes axes{frame(canvas, place, "Apart", value), stage.time(), -12, 1.5};
    level(canvas, axes, -3, "1 mm");
    level(canvas, axes, -9, "1 nm");
    curve(canvas, axes, history, colour::text, decades);
}

}  // namespace

void draw_strip(Canvas& canvas, const Rect& place, const Stage& stage) {
    if (stage.runs().size() == 1) return draw_energy(canvas, place, stage);
    const double gap = canvas.scaled(6), half = std::floor(0.5 * (place.width - gap));
    draw_distance(canvas, {place.x, place.y, half, place.height}, stage);
    draw_energy(canvas, {place.x + half + gap, place.y, place.width - half - gap, place.height}, stage);
}

}  // namespace flipside::app

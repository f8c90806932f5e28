#include "app/window/header.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <vector>

#include "app/window/contender_colour.hpp"
#include "app/window/led.hpp"
#include "app/window/words.hpp"

namespace flipside::app {

namespace {

constexpr double led_height = 21, small_led_height = 14;  ///< px on an ordinary display
constexpr int led_digits = 6;

std::string energy_in_words(double drift) {
    // A ten-billionth of a joule is rounding.
    if (std::abs(drift) < 1e-10) return "energy kept";
    return engineering(std::abs(drift), "J") + (drift < 0 ? " lost" : " gained");
}

/// What an engine that accounts for its own errors may still say.
std::string claim_in_words(const Run& run) {
    if (const auto& time = run.passed_horizon()) return "horizon passed at " + with_unit(*time, 2, "s");
    const double worst = run.uncertainty_history().back().value;
    return worst > 0 ? "sure to " + in_radii(worst) : "exact";
}

/// The solver, or of an engine that has only one the library and its version, whose speed stands below; the
/// engine first where the contender has another name.
std::string method(const Run& run) {
    const std::string_view solver = run.session().world().statistics().solver;
    const std::string how(solver.empty() ? run.engine().library : solver);
    return run.name() == run.engine().name ? how : std::string(run.engine().name) + " " + how;
}

std::string cost_in_words(const Run& run, bool per_second) {
    return per_second ? engineering(run.cost_per_second(), "s") + " per simulated s"
                      : engineering(run.step_cost(), "s") + " per step";
}

/// In one line for each of `rooms`, px. What does not fit is left out from the end.
std::vector<std::string> facts(const Canvas& canvas, const Run& run, bool per_second,
                               std::optional<double> pace, std::span<const double> rooms) {
    const World& world = run.session().world();
    const auto asleep = static_cast<std::size_t>(
        std::ranges::count_if(world.balls(), [](const Ball& ball) { return ball.asleep; }));
    std::vector<std::string> parts{balls_in_words(world.balls().size(), asleep)};
    if (pace) parts.push_back("slow: " + with_unit(*pace, 2, "×"));
    if (!run.uncertainty_history().empty()) parts.push_back(claim_in_words(run));
    if (run.step_cost() > 0) parts.push_back(cost_in_words(run, per_second));
    if (!world.balls().empty()) parts.push_back(energy_in_words(run.energy_drift()));
    std::vector<std::string> lines(1);
    const auto fits = [&](const std::string& words) {
        return canvas.lettering().width(words, Type::small) <= rooms[lines.size() - 1];
    };
    for (const std::string& part : parts) {
        const std::string longer = lines.back().empty() ? part : lines.back() + "  ·  " + part;
        if (fits(longer) || lines.size() == rooms.size()) {
            if (!fits(longer) && !lines.back().empty()) break;
            lines.back() = longer;
        } else {
            lines.push_back(part);
        }
    }
    for (std::size_t i = 0; i < lines.size(); ++i) {
        lines[i] = canvas.lettering().cut(lines[i], Type::small, rooms[i]);
        if (lines[i] == "…") lines[i].clear();  // there is no room beside the score
    }
    return lines;
}

/// The score in figures of that height and, where there is room from `left` on, the balls left: flush right
/// on the line with its middle at `y`. Returns where they begin, px.
double draw_score(Canvas& canvas, double left, double right, double y, double height, const lab::Game& game,
                  long score) {
    const double begin = right - led_width(led_digits, height);
    draw_led(canvas, {begin, y - 0.5 * height}, height, led_digits, score, colour::lit);
    const int balls = std::min(game.balls_left(), 5);
    const double room = canvas.scaled(14 * balls + 8);
    if (begin - room < left) return begin;
    for (int i = 0; i < balls; ++i)
        canvas.steel({begin - canvas.scaled(14 + 14 * i), y + canvas.scaled(0.5)}, canvas.scaled(5),
                     sf::Color::Transparent);
    return begin - room;
}

/// The step and, where there is room too, the solver or at least the engine before it, in the line of the
/// name.
std::optional<Rect> draw_step(Canvas& canvas, const Run& run, double left, double right, double top) {
    const auto width_of = [&](const std::string& words) {
        return canvas.lettering().width(words, Type::small);
    };
    const std::string step = step_in_words(run.dt()), engine(run.engine().name);
    const double pad = canvas.scaled(6), frame = width_of(step) + 2 * pad;
    for (const std::string& how : {method(run), run.name() == engine ? "" : engine, std::string()}) {
        const double begin = left + (how.empty() ? 0 : width_of(how) + canvas.scaled(8));
        if (begin + frame > right) continue;
        canvas.text({left, top + canvas.scaled(3)}, how, Type::small, colour::quiet);
        const Rect place{begin, top, frame, canvas.scaled(22)};
        canvas.rectangle({place.x, place.y}, {place.x + place.width, place.y + place.height}, colour::rule);
        canvas.text({begin + pad, top + canvas.scaled(3)}, step, Type::small, colour::text);
        return place;
    }
    return std::nullopt;
}

}  // namespace

std::optional<Rect> draw_header(Canvas& canvas, const Rect& place, const Run& run, long score,
                                bool per_second, std::optional<double> pace) {
    const lab::Session& session = run.session();
    const sf::Color color = colour_of(run);
    const double margin = canvas.scaled(12), left = place.x + margin;
    canvas.rectangle({place.x, place.y}, {place.x + place.width, place.y + place.height}, colour::raised);
    canvas.rectangle({place.x, place.y}, {place.x + place.width, place.y + canvas.scaled(3)}, color);

    const double room = place.width - 2 * margin;
    const bool fits = canvas.lettering().width(run.name(), Type::large) <= room;
    const Type type = fits ? Type::large : Type::small;
    const std::string name = canvas.lettering().cut(run.name(), type, room);
    canvas.text({left, place.y + canvas.scaled(fits ? 9 : 12)}, name, type, color);
    const double after = left + canvas.lettering().width(name, type) + canvas.scaled(9);
    const double right = place.x + place.width - margin;
    double y = place.y + canvas.scaled(37);
    // The score is beside the name, or below it in a narrow pane, whatever the name.
    double free = right, free_below = right;
    if (session.scene().rules && place.width > canvas.scaled(240))
        free = draw_score(canvas, after, right, place.y + canvas.scaled(19.5), canvas.scaled(led_height),
                          session.game(), score);
    else if (session.scene().rules)
        free_below = draw_score(canvas, right, right, place.y + canvas.scaled(45),
                                canvas.scaled(small_led_height), session.game(), score) -
                     margin;
    const std::optional<Rect> step = draw_step(canvas, run, after, free, place.y + canvas.scaled(10));
    if (const auto& halt = run.halt()) {
        canvas.text({left, y}, "stopped at " + with_unit(halt->time, 2, "s"), Type::small, colour::warning);
        return step;
    }
    std::vector<double> rooms(static_cast<std::size_t>(lines_of_facts(place.height / canvas.scaled(1))),
                              right - left);
    rooms.front() = free_below - left;
    for (const std::string& line : facts(canvas, run, per_second, pace, rooms)) {
        canvas.text({left, y}, line, Type::small, colour::text);
        y += canvas.scaled(20);
    }
    return step;
}

}  // namespace flipside::app

#include "app/window/header.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "app/window/led.hpp"
#include "app/window/words.hpp"

namespace flipside::app {

namespace {

std::string energy_in_words(double drift) {
    // A ten-billionth of a joule is rounding.
    if (std::abs(drift) < 1e-10) return "energy kept";
    return engineering(std::abs(drift), "J") + (drift < 0 ? " lost" : " gained");
}

/// What does not fit is left out from the end.
std::string facts(const Canvas& canvas, const Run& run, double room) {
    const World& world = run.session().world();
    const auto asleep = static_cast<std::size_t>(
        std::ranges::count_if(world.balls(), [](const Ball& ball) { return ball.asleep; }));
    const std::string parts[] = {balls_in_words(world.balls().size(), asleep),
                                 engineering(run.step_cost(), "s") + " per step",
                                 energy_in_words(run.energy_drift())};
    std::string line;
    for (const std::string& part : parts) {
        const std::string longer = line.empty() ? part : line + "  ·  " + part;
        if (canvas.lettering().width(longer, Type::small) > room && !line.empty()) break;
        line = longer;
    }
    return line;
}

/// The score and the balls left, flush right; returns the room they took, px.
double draw_score(Canvas& canvas, const Rect& place, const lab::Game& game, long score) {
    const double height = canvas.scaled(21), margin = canvas.scaled(12);
    const double width = led_width(6, height), left = place.x + place.width - margin - width;
    draw_led(canvas, {left, place.y + canvas.scaled(9)}, height, 6, score, colour::lit);
    const int balls = std::min(game.balls_left(), 5);
    for (int i = 0; i < balls; ++i)
        canvas.steel({left - canvas.scaled(14 + 14 * i), place.y + canvas.scaled(20)}, canvas.scaled(5),
                     sf::Color::Transparent);
    return width + margin + canvas.scaled(14 * balls + 8);
}

}  // namespace

void draw_header(Canvas& canvas, const Rect& place, const Run& run, long score) {
    const lab::Session& session = run.session();
    const sf::Color color = engine_colour(session.engine().name);
    const double margin = canvas.scaled(12), left = place.x + margin;
    canvas.rectangle({place.x, place.y}, {place.x + place.width, place.y + place.height}, colour::raised);
    canvas.rectangle({place.x, place.y}, {place.x + place.width, place.y + canvas.scaled(3)}, color);

    const std::string name(session.engine().name);
    canvas.text({left, place.y + canvas.scaled(9)}, name, Type::large, color);
    const double after = left + canvas.lettering().width(name, Type::large) + canvas.scaled(9);
    double taken = margin;
    if (session.scene().rules) taken += draw_score(canvas, place, session.game(), score);
    const std::string solver(session.world().statistics().solver);
    if (after + canvas.lettering().width(solver, Type::small) < place.x + place.width - taken)
        canvas.text({after, place.y + canvas.scaled(13)}, solver, Type::small, colour::quiet);
    const double y = place.y + canvas.scaled(37);
    if (const auto& halt = run.halt())
        canvas.text({left, y}, "stopped at " + with_unit(halt->time, 2, "s"), Type::small, colour::warning);
    else
        canvas.text({left, y}, facts(canvas, run, place.width - 2 * margin), Type::small, colour::text);
}

}  // namespace flipside::app

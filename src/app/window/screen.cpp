#include "app/window/screen.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "app/window/advice.hpp"
#include "app/window/contender_colour.hpp"
#include "app/window/header.hpp"
#include "app/window/overlays.hpp"
#include "app/window/pane_view.hpp"
#include "app/window/pick_view.hpp"
#include "app/window/playfield/captions.hpp"
#include "app/window/playfield/effects.hpp"
#include "app/window/stage_view.hpp"
#include "app/window/strip.hpp"
#include "app/window/words.hpp"

namespace flipside::app {

Layout layout_of(const Stage& stage, double width, double height, double scale, Column column, bool step_bar,
                 double strip) {
    const int runs = static_cast<int>(stage.runs().size());
    const Vec2 extent = view_bounds(stage.scene()).max - view_bounds(stage.scene()).min;
    const int panes = stage.view() == View::split ? runs : 1;
    return lay_out(width, height, scale,
                   {panes, runs, extent.x / extent.y, column, step_bar, column != Column::none, strip});
}

void Screen::draw(sf::RenderTarget& target, const Stage& stage, const Layout& layout, const Camera& camera,
                  const Look& look, const Readings& readings, const Microscope* inside) {
    target.clear(colour::around);
    const std::span<const Run> runs = stage.runs();
    for (std::size_t i = 0; i < layout.panes.size(); ++i)
        draw_pane(target, stage, layout.panes[i], layout.panes.size() == 1 ? runs : runs.subspan(i, 1),
                  camera, look, inside);
    const sf::Vector2f all(target.getSize());
    target.setView(sf::View({0, 0, all.x, all.y}));
    draw_pace(layout.panes.front(), layout.panes.back().x + layout.panes.back().width, readings);
    const Run& costliest = *std::ranges::max_element(runs, {}, &Run::cost_per_second);
    const bool slow = readings.reached < 0.95 * readings.asked;
    steps_.clear();
    for (std::size_t i = 0; i < layout.headers.size(); ++i)
        steps_.push_back(
            draw_header(canvas_, layout.headers[i], runs[i], readings.scores[i], stage.steps_differ(),
                        slow && &runs[i] == &costliest ? std::optional(readings.reached) : std::nullopt));
    draw_strip(canvas_, layout.strip, stage, readings.plots, readings.mouse);
    canvas_.flush(target);
    if (readings.end != nullptr) draw_game_end(canvas_, layout, *readings.end);
    canvas_.flush(target);
}

void Screen::draw_pane(sf::RenderTarget& target, const Stage& stage, const Rect& place,
                       std::span<const Run> runs, const Camera& camera, const Look& look,
                       const Microscope* inside) {
    target.setView(view_of_pane(target, place));
    const bool alone = runs.size() == 1;
    const Run& front = alone ? runs.front() : stage.lead();
    draw_ground(target, camera, front, look, inside != nullptr);
    draw_table(canvas_, camera, front, look);
    if (!inside) draw_words(stage, place, runs, look);
    canvas_.flush(target);  // balls roll over letters
    // On one table, what has stopped at another time is not seen together with what goes on.
    const auto seen = [&](const Run& run) { return alone || !run.halt(); };
    const auto balls_of = [&](const Run& run) {
        return inside ? inside->balls(static_cast<std::size_t>(&run - stage.runs().data()))
                      : run.session().world().balls();
    };
    const bool looked_into = inside && std::ranges::any_of(runs, [&](const Run& run) {
                                 return &run == &stage.runs()[inside->run()];
                             });
    if (looked_into) canvas_.rectangle({}, {place.width, place.height}, with_alpha(colour::around, 0.45));
    // A stage shows what it looked at itself; overlays are of the end of the step, which is its last stage.
    const bool over = inside == nullptr || inside->at() + 1 == inside->stages().size();
    for (const Run& run : runs)
        if (seen(run) && !(looked_into && !over && &run == &stage.runs()[inside->run()]))
            draw_overlays(canvas_, camera, run, look);
    for (const Run& run : runs)
        if (look.artwork && !inside && seen(run)) draw_trails(canvas_, camera, run, balls_of(run));
    for (const Run& run : runs) {
        if (!seen(run)) continue;
        if (!alone && is_reference(run.engine()))
            draw_halos(canvas_, camera, run, balls_of(run));
        else
            draw_balls(canvas_, camera, run, balls_of(run), look);
    }
    for (const Run& run : runs)
        if (look.artwork && !inside && seen(run)) draw_sparks(canvas_, camera, run);
    for (const Run& run : runs)
        if (seen(run)) draw_picked(canvas_, camera, balls_of(run), look);
    if (!inside) draw_links_of(runs, camera);
    for (const Run& run : runs)
        if (seen(run) && over) draw_marks(canvas_, camera, run, look, alone);
    if (looked_into)
        draw_stage_items(canvas_, camera, inside->stage(), inside->item(), inside->balls(inside->run()),
                         colour_of(stage.runs()[inside->run()]));
    for (const Run& run : runs)
        if (run.halt()) draw_halt(stage, place, run, alone);
    canvas_.flush(target);
}

void Screen::draw_ground(sf::RenderTarget& target, const Camera& camera, const Run& run, const Look& look,
                         bool dimmed) {
    const std::shared_ptr<const Scene> scene = run.session().shared_scene();
    if (!look.artwork || !ground_.draw(target, canvas_, scene, camera, dimmed || has_overlays(look)))
        draw_bare_ground(canvas_, camera, *scene);
    draw_inserts(canvas_, camera, ground_.inserts(scene), run);
}

/// What the rules have to tell, or else what the player can do. Where several runs are on one table each
/// tells in its colour; what all of them tell stands there once.
void Screen::draw_words(const Stage& stage, const Rect& place, std::span<const Run> runs, const Look& look) {
    CaptionWriter writer(canvas_, place);
    std::vector<std::pair<CaptionWords, sf::Color>> told;
    for (const Run& run : runs)
        if (auto words = caption_of(run.session().game(), run.session().world().time()))
            told.emplace_back(std::move(*words), colour_of(run));
    const auto first_says = [&](const auto& other) {
        return other.first.title == told.front().first.title &&
               other.first.detail == told.front().first.detail;
    };
    if (told.size() == runs.size() && std::ranges::all_of(told, first_says))
        writer.write(told.front().first, colour::lit);
    else
        for (const auto& [words, color] : told) writer.write(words, color);
    const auto words = !told.empty() || look.charge > 0 || !look.advice ? std::nullopt : advice(runs, stage);
    if (words) writer.write(*words, colour::text);
}

/// In the corner of the first pane: why nothing moves, or moves slowly. Panes end at `right`, px.
void Screen::draw_pace(const Rect& place, double right, const Readings& readings) {
    const std::string words =
        readings.past > 0 ? "PAUSED  ·  " + with_unit(readings.past, 2, "s") + " back  ·  P goes on from here"
        : readings.paused        ? "PAUSED  ·  P goes on"
        : !readings.slow.empty() ? readings.slow
        : readings.speed < 1     ? with_unit(readings.speed, 2, "× time")
                                 : "";
    if (words.empty()) return;
    const double pad = canvas_.scaled(6), line = lettering_.line_height(Type::small);
    std::vector<std::string> lines = lettering_.lines(words, Type::small, place.width - 4 * pad);
    // In a small pane the beginning says enough, and it may reach over the next one.
    if (line * static_cast<double>(lines.size()) + 3 * pad > std::max(0.5 * place.height, 2 * line))
        lines = {lettering_.cut(words.substr(0, words.find("  ·")), Type::small, right - place.x - 4 * pad)};
    double width = 0;
    for (const std::string& words_of_line : lines)
        width = std::max(width, lettering_.width(words_of_line, Type::small));
    Vec2 at{place.x + pad, place.y + pad};
    canvas_.rectangle(at, at + Vec2{width + 2 * pad, line * static_cast<double>(lines.size()) + pad},
                      with_alpha(colour::raised, 0.85));
    at += Vec2{pad, 0.5 * pad};
    for (const std::string& words_of_line : lines) {
        canvas_.text(at, words_of_line, Type::small, colour::lit);
        at.y += line;
    }
}

/// From each run to the reference, or else to the first.
void Screen::draw_links_of(std::span<const Run> runs, const Camera& camera) {
    const auto exact = std::ranges::find_if(runs, [](const Run& run) { return is_reference(run.engine()); });
    const Run& base = exact == runs.end() ? runs.front() : *exact;
    // Past its horizon the reference does not know where its balls are.
    if (!base.is_measure_at(base.session().world().time())) return;
    for (const Run& run : runs)
        if (&run != &base && !run.halt() && !base.halt())
            draw_links(canvas_, camera, run, base, exact == runs.end() ? colour::text : colour_of(run));
}

/// Why the run has halted, and what can be done, at the foot of the pane, where it hides least.
void Screen::draw_halt(const Stage& stage, const Rect& place, const Run& run, bool alone) {
    const double pad = canvas_.scaled(12), line = lettering_.line_height(Type::small);
    const double room = std::min(place.width - 4 * pad, canvas_.scaled(alone ? 320 : 230));
    const std::string name(run.engine().name);
    // Reasons begin with the engine's name, for the command line.
    std::string reason = run.halt()->reason;
    if (reason.starts_with(name + ": ")) reason.erase(0, name.size() + 2);
    const std::string words = sentence(name) + " stopped: " + reason;
    const std::vector<std::string> why = lettering_.lines(words, Type::small, room);
    const std::vector<std::string> then =
        lettering_.lines(stage.guide() ? "T takes it up again from the state on show"
                                       : "R to restart, Tab for the next engine",
                         Type::small, room);
    const double height = line * static_cast<double>(why.size() + then.size()) + 2.5 * pad;
    const Vec2 corner{alone ? std::round(0.5 * (place.width - room) - pad) : pad,
                      place.height - pad - height};
    canvas_.rectangle(corner, corner + Vec2{room + 2 * pad, height}, with_alpha(colour::raised, 0.94));
    canvas_.rectangle(corner, corner + Vec2{canvas_.scaled(3), height}, colour::warning);
    Vec2 at = corner + Vec2{pad, pad};
    for (const std::string& text : why) {
        canvas_.text(at, text, Type::small, colour::text);
        at.y += line;
    }
    at.y += 0.5 * pad;
    for (const std::string& text : then) {
        canvas_.text(at, text, Type::small, colour::quiet);
        at.y += line;
    }
}

}  // namespace flipside::app

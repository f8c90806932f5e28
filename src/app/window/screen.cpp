#include "app/window/screen.hpp"

#include <string>

#include "app/window/header.hpp"
#include "app/window/overlays.hpp"
#include "app/window/strip.hpp"

namespace flipside::app {

namespace {

/// What to do now, where that is not plain to see.
std::string advice(const lab::Session& session) {
    const lab::Game& game = session.game();
    if (session.scene().rules && game.over()) return "Game over: R to play again";
    if (game.tilted()) return "Tilt";
    if (!session.world().balls().empty()) return "";
    if (!session.scene().launcher) return "No balls: R to restart";
    return session.world().save().launches.empty() ? "Space to launch" : "";
}

/// Lets through what lies in `place` only, with its top left corner as the origin.
sf::View view_of(const sf::RenderTarget& target, const Rect& place) {
    const auto f = [](double v) { return static_cast<float>(v); };
    const sf::Vector2f all(target.getSize());
    sf::View view({0, 0, f(place.width), f(place.height)});
    view.setViewport(
        {f(place.x) / all.x, f(place.y) / all.y, f(place.width) / all.x, f(place.height) / all.y});
    return view;
}

}  // namespace

const Box& sight_of(const Scene& scene) {
    return scene.camera ? *scene.camera : scene.bounds;
}

Layout layout_of(const Stage& stage, double width, double height, double scale, Column column) {
    const int runs = static_cast<int>(stage.runs().size());
    return lay_out(width, height, scale, stage.view() == View::split ? runs : 1, runs, column);
}

void Screen::draw(sf::RenderTarget& target, const Stage& stage, const Layout& layout, const Camera& camera,
                  const Look& look, const std::vector<long>& scores) {
    target.clear(colour::around);
    const std::span<const Run> runs = stage.runs();
    for (std::size_t i = 0; i < layout.panes.size(); ++i)
        draw_pane(target, layout.panes[i], layout.panes.size() == 1 ? runs : runs.subspan(i, 1), camera,
                  look);
    const sf::Vector2f all(target.getSize());
    target.setView(sf::View({0, 0, all.x, all.y}));
    for (std::size_t i = 0; i < layout.headers.size(); ++i)
        draw_header(canvas_, layout.headers[i], runs[i], scores[i]);
    draw_strip(canvas_, layout.strip, stage);
    canvas_.flush(target);
}

void Screen::draw_pane(sf::RenderTarget& target, const Rect& place, std::span<const Run> runs,
                       const Camera& camera, const Look& look) {
    target.setView(view_of(target, place));
    draw_table(canvas_, camera, runs.front(), look);
    for (const Run& run : runs) draw_overlays(canvas_, camera, run, look);
    for (const Run& run : runs) draw_balls(canvas_, camera, run, look);
    for (const Run& run : runs.subspan(1)) draw_links(canvas_, camera, runs.front(), run);
    for (const Run& run : runs) draw_marks(canvas_, camera, run, look);
    if (look.charge == 0)
        canvas_.text({0.5 * place.width, 0.57 * place.height}, advice(runs.front().session()), Type::large,
                     colour::text, Align::center);
    canvas_.flush(target);
}

}  // namespace flipside::app

#include "app/render.hpp"

#include <algorithm>
#include <stdexcept>

#include <SFML/Graphics/RenderTexture.hpp>

#include "app/window/png_file.hpp"
#include "app/window/screen.hpp"
#include "world/input_error.hpp"
#include "world/refusal.hpp"

namespace flipside::app {

namespace {

Shows parse_shows(const std::vector<std::string>& names) {
    Shows shows = Look{}.shows;
    for (const std::string& name : names) {
        const auto* spec = std::ranges::find(show_specs, name, &ShowSpec::name);
        if (spec == std::end(show_specs)) {
            std::string known;
            for (const ShowSpec& one : show_specs)
                known += (known.empty() ? "" : ", ") + std::string(one.name);
            throw InputError("--show: unknown overlay '" + name + "'; known: " + known);
        }
        shows.set(static_cast<std::size_t>(spec - show_specs));
    }
    return shows;
}

/// "NAME=VALUE" means the chosen engine.
std::vector<std::string> named_settings(const RenderOptions& options) {
    std::vector<std::string> settings = options.settings;
    const std::string engine(lab::engine_named(options.engine).name);
    for (std::string& text : settings)
        if (text.substr(0, text.find('=')).find('.') == std::string::npos) text = engine + "." + text;
    return settings;
}

}  // namespace

int render(const RenderOptions& options) {
    Look look;
    look.shows = parse_shows(options.show);
    look.artwork = options.artwork;
    Stage stage(options.scene, options.engine, options.view, named_settings(options), options.script, {},
                options.dt);
    stage.run_until(options.at);
    for (const Run& run : stage.runs())
        if (run.halt() && &run.engine() == &lab::engine_named(options.engine))
            throw Refusal(run.halt()->reason);

    sf::RenderTexture picture;
    if (!picture.create(options.width, options.height))
        throw std::runtime_error("cannot make a picture of " + std::to_string(options.width) + " x " +
                                 std::to_string(options.height) + " pixels");
    Screen screen(1);
    const Layout layout = layout_of(stage, options.width, options.height, screen.scale(), Column::none);
    Camera camera;
    camera.size = {layout.panes.front().width, layout.panes.front().height};
    camera.fit(sight_of(stage.scene()), screen.scale() * pane_margin);
    Readings readings;
    for (const Run& run : stage.runs()) readings.scores.push_back(run.session().game().score());
    const GameEnd end = end_of(stage);
    if (is_over(stage)) readings.end = &end;
    screen.draw(picture, stage, layout, camera, look, readings);
    picture.display();
    write_png(picture.getTexture().copyToImage(), options.out);
    return 0;
}

}  // namespace flipside::app

#include "app/render.hpp"

#include <algorithm>

#include "app/painter.hpp"
#include "app/window/png_file.hpp"
#include "app/window/stage.hpp"
#include "world/input_error.hpp"
#include "world/refusal.hpp"

namespace flipside::app {

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

std::string render(const RenderOptions& options) {
    Look look;
    look.shows = parse_shows(options.show);
    look.artwork = options.artwork;
    Stage stage(options.scene, options.engine, options.view, options.settings, options.script, {},
                options.dt);
    stage.run_until(options.at);
    for (const Run& run : stage.runs())
        if (run.halt() && &run.engine() == &lab::engine_named(options.engine))
            throw Refusal(run.halt()->reason);

    return png_of(Painter(options.width, options.height, 1).paint(stage, look));
}

}  // namespace flipside::app

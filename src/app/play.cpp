#include "app/play.hpp"

#include "app/window/app.hpp"
#include "app/window/display.hpp"

namespace flipside::app {

int play(const PlayOptions& options) {
    require_display();
    App(options).run();
    return 0;
}

}  // namespace flipside::app

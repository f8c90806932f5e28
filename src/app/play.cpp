#include "app/play.hpp"

#include "app/window/app.hpp"

namespace flipside::app {

int play(const PlayOptions& options) {
    App(options).run();
    return 0;
}

}  // namespace flipside::app

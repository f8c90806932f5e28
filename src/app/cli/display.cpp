#include "app/cli/display.hpp"

#include <cstdlib>
#include <string>

#include <X11/Xlib.h>

#include "lab/process/failure.hpp"

namespace flipside::app {

void require_display() {
    const char* name = std::getenv("DISPLAY");
    const bool named = name != nullptr && *name != '\0';
    // It stays open until the program ends: a server whose last client leaves may reset itself, as Xvfb does,
    // and then refuses the next one for a moment.
    static const Display* kept = nullptr;
    if (named) kept = XOpenDisplay(name);
    if (kept != nullptr) return;
    const std::string why =
        named ? "no X server answers at DISPLAY=" + std::string(name) : "DISPLAY is not set";
    throw lab::Failure("no display (" + why + "); run and compare need none, and xvfb-run gives one");
}

}  // namespace flipside::app

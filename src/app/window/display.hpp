#pragma once
/// Whether there is anything to draw on. SFML ends the whole program where there is not, so this is asked
/// first.

#include <cstdlib>
#include <stdexcept>

namespace flipside::app {

/// Throws std::runtime_error that says what to do.
inline void require_display() {
#ifdef __linux__
    const char* display = std::getenv("DISPLAY");
    if (!display || *display == '\0')
        throw std::runtime_error("no display: start it in a graphical session, or under xvfb-run");
#endif
}

}  // namespace flipside::app

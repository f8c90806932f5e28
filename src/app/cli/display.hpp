#pragma once
/// SFML ends the program by a signal where it finds no X server, so one is looked for first.

namespace flipside::app {

/// Throws lab::Failure where DISPLAY names no X server that answers.
void require_display();

}  // namespace flipside::app

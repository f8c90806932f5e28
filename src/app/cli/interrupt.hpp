#pragma once
/// Ctrl-C during long work: the work stops at its next step, and files that are not finished vanish.

namespace flipside::app {

/// From now on SIGINT and SIGTERM are noted; a second one ends the program at once.
void catch_interrupts();
/// Throws lab::Failure after an interrupt.
void stop_if_interrupted();

}  // namespace flipside::app

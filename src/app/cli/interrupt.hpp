#pragma once
/// Ctrl-C and termination. They end the program at once, wherever it is: a step of 100,000 balls may last for
/// minutes. Nothing has to be unwound, since files appear by renaming; what is unfinished is removed.

namespace flipside::app {

/// From now on SIGINT and SIGTERM end the program with exit code 1 and one line, leaving whole files only.
void end_on_interrupts();

}  // namespace flipside::app

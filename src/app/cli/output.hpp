#pragma once
/// What the commands say: text on stdout, messages on stderr. Nothing else in the program writes to either,
/// but for the progress bar.

#include <string_view>

namespace flipside::app {

/// Before anything else: a standard stream that is closed is opened on /dev/null, stdout so that writing to
/// it fails, for otherwise the next file opened would take its number. And what a write to a closed pipe or
/// past the limit of a file's size meets is an error, not a signal.
void prepare_streams();

/// printf to stdout. Of control characters only \n gets there; text from files and arguments must be
/// printable() before, so that it cannot make lines of its own. Throws lab::Failure when it cannot be
/// written.
[[gnu::format(printf, 1, 2)]] void print(const char* format, ...);
void print_text(std::string_view text);

/// Throws lab::Failure when not all that was printed could be written.
void finish_output();

/// One line on stderr, "flipside: MESSAGE", whatever the message holds.
void say(std::string_view message);

}  // namespace flipside::app

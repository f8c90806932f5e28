#include "app/cli/output.hpp"

#include <cerrno>
#include <csignal>
#include <cstdarg>
#include <cstdio>
#include <string>
#include <system_error>
#include <vector>

#include <fcntl.h>
#include <unistd.h>

#include "lab/process/failure.hpp"
#include "world/printable.hpp"

namespace flipside::app {

namespace {

/// A new file takes the lowest free number, and those below are open.
void fill(int stream, int mode) {
    if (fcntl(stream, F_GETFD) < 0) static_cast<void>(open("/dev/null", mode));
}

[[noreturn]] void fail(int error) {
    throw lab::Failure("standard output: cannot be written (" + std::generic_category().message(error) + ")");
}

}  // namespace

void prepare_streams() {
    fill(STDIN_FILENO, O_RDONLY);
    fill(STDOUT_FILENO, O_RDONLY);
    fill(STDERR_FILENO, O_WRONLY);
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
}

void print(const char* format, ...) {
    std::va_list arguments, again;
    va_start(arguments, format);
    va_copy(again, arguments);
    std::vector<char> text(static_cast<std::size_t>(std::vsnprintf(nullptr, 0, format, arguments)) + 1);
    va_end(arguments);
    std::vsnprintf(text.data(), text.size(), format, again);
    va_end(again);
    print_text(text.data());
}

void print_text(std::string_view text) {
    const std::string shown = printable_lines(text);
    if (std::fwrite(shown.data(), 1, shown.size(), stdout) != shown.size()) fail(errno);
}

void finish_output() {
    if (std::fflush(stdout) != 0) fail(errno);
}

void say(std::string_view message) {
    const std::string line = "flipside: " + printable(message) + "\n";
    static_cast<void>(std::fputs(line.c_str(), stderr));
}

}  // namespace flipside::app

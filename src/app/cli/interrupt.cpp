#include "app/cli/interrupt.hpp"

#include <csignal>
#include <cstring>

#include <unistd.h>

#include "lab/process/unfinished.hpp"

namespace flipside::app {

namespace {

/// On a terminal the line of the progress bar is wiped first. Set before the handler is.
const char* message = "";

/// Only what is safe in a signal handler.
void end_program(int /*signal*/) {
    lab::abandon_unfinished();
    [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, message, std::strlen(message));
    constexpr int could_not_be_done = 1;
    _exit(could_not_be_done);
}

}  // namespace

void end_on_interrupts() {
    message = isatty(STDERR_FILENO) != 0 ? "\r\033[Kflipside: interrupted\n" : "flipside: interrupted\n";
    constexpr int signals[] = {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGXCPU};
    struct sigaction action {};
    action.sa_handler = end_program;
    sigemptyset(&action.sa_mask);
    for (const int signal : signals) sigaddset(&action.sa_mask, signal);
    for (const int signal : signals) {
        struct sigaction before {};
        sigaction(signal, nullptr, &before);
        // nohup, or a shell that runs a command in the background, asks that a signal be ignored.
        if (before.sa_handler != SIG_IGN) sigaction(signal, &action, nullptr);
    }
}

}  // namespace flipside::app

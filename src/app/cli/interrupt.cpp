#include "app/cli/interrupt.hpp"

#include <csignal>

#include "lab/failure.hpp"

namespace flipside::app {

namespace {

volatile std::sig_atomic_t interrupted = 0;

void note(int signal) {
    interrupted = 1;
    std::signal(signal, SIG_DFL);
}

}  // namespace

void catch_interrupts() {
    std::signal(SIGINT, note);
    std::signal(SIGTERM, note);
}

void stop_if_interrupted() {
    if (interrupted != 0) throw lab::Failure("interrupted");
}

}  // namespace flipside::app

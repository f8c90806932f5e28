#include "fuzz/oracle.hpp"

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>

#include <boost/crc.hpp>
#include <sys/time.h>
#include <unistd.h>

namespace flipside::fuzz {

namespace {

const char* subject = "reader";

void set_timer(double seconds) {
    itimerval timer{};
    timer.it_value.tv_sec = static_cast<time_t>(seconds);
    timer.it_value.tv_usec = static_cast<suseconds_t>((seconds - std::floor(seconds)) * 1e6);
    setitimer(ITIMER_VIRTUAL, &timer, nullptr);
}

extern "C" void took_too_long(int /*signal*/) {
    const auto print = [](std::string_view text) {
        static_cast<void>(!write(STDERR_FILENO, text.data(), text.size()));
    };
    print("violation: ");
    print(subject);
    print(": an answer took more CPU time than allowed\n");
    abort();
}

}  // namespace

void set_subject(const char* name) {
    subject = name;
}

void report_violation(const std::string& what) {
    std::fprintf(stderr, "violation: %s: %s\n", subject, what.c_str());
    std::abort();
}

void require_printable(const std::string& message) {
    const auto control = [](char c) { return static_cast<unsigned char>(c) < ' ' || c == '\x7f'; };
    if (message.empty() || std::ranges::any_of(message, control))
        report_violation("a message is empty or holds control characters: " + message);
}

CpuLimit::CpuLimit(double seconds) {
    std::signal(SIGVTALRM, took_too_long);
    set_timer(seconds);
}

CpuLimit::~CpuLimit() {
    set_timer(0);
}

unsigned variation_of(std::string_view input) {
    boost::crc_32_type crc;
    crc.process_bytes(input.data(), input.size());
    return crc.checksum();
}

}  // namespace flipside::fuzz

#include "app/cli/progress.hpp"

#include <algorithm>
#include <cstdio>
#include <string>

#include <unistd.h>

namespace flipside::app {

namespace {

/// "1:02:05", "2:05", "0:05".
std::string clock_text(double seconds) {
    const auto whole = static_cast<long>(std::min(seconds, 359'999.0));
    char text[24];
    if (whole >= 3600)
        std::snprintf(text, sizeof text, "%ld:%02ld:%02ld", whole / 3600, whole / 60 % 60, whole % 60);
    else
        std::snprintf(text, sizeof text, "%ld:%02ld", whole / 60, whole % 60);
    return text;
}

}  // namespace

Progress::Progress(double whole) : whole_(whole), shown_(isatty(STDERR_FILENO) != 0) {}

Progress::~Progress() {
    if (shown_) std::fputs("\r\033[K", stderr);
}

void Progress::at(double done) {
    if (!shown_) return;
    const auto now = Clock::now();
    const double share = whole_ > 0 ? std::clamp(done / whole_, 0.0, 1.0) : 1;
    if (first_ < 0) first_ = share, began_ = now;
    if (now < next_) return;
    next_ = now + std::chrono::milliseconds(100);

    constexpr int width = 40;
    const auto full = static_cast<std::size_t>(share * width);
    const std::string bar = std::string(full, '#') + std::string(width - full, '-');
    const double taken = std::chrono::duration<double>(now - began_).count();
    std::string left;
    if (taken > 1 && share > first_) left = clock_text(taken * (1 - share) / (share - first_)) + " left";
    std::fprintf(stderr, "\r[%s] %3.0f %%  %s\033[K", bar.c_str(), 100 * share, left.c_str());
    std::fflush(stderr);
}

}  // namespace flipside::app

#include "app/cli/progress.hpp"

#include <algorithm>
#include <cstdio>
#include <string>

#include <unistd.h>

namespace flipside::app {

Progress::Progress(double seconds) : seconds_(seconds), shown_(isatty(STDERR_FILENO) != 0) {}

Progress::~Progress() {
    if (shown_) std::fputs("\r\033[K", stderr);
}

void Progress::at(double seconds_done) {
    if (!shown_) return;
    const auto now = std::chrono::steady_clock::now();
    if (now < next_) return;
    next_ = now + std::chrono::milliseconds(100);

    constexpr int width = 40;
    const double share = seconds_ > 0 ? std::clamp(seconds_done / seconds_, 0.0, 1.0) : 1;
    const auto full = static_cast<std::size_t>(share * width);
    const std::string bar = std::string(full, '#') + std::string(width - full, '-');
    std::fprintf(stderr, "\r[%s] %3.0f %%  %.1f of %g s", bar.c_str(), 100 * share, seconds_done, seconds_);
    std::fflush(stderr);
}

}  // namespace flipside::app

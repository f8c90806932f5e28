#include "lab/session/timeline.hpp"

#include <cmath>

namespace flipside::lab {

Timeline::Timeline(double start, double seconds, double dt)
    : start_(start), seconds_(seconds), dt_(dt), last_(dt) {
    constexpr double no_step = 1e-9;
    const double whole = std::floor(seconds / dt + no_step);
    steps_ = static_cast<std::uint64_t>(whole);
    const double rest = seconds - whole * dt;
    if (rest <= no_step * dt) return;
    ++steps_;
    last_ = rest;
}

}  // namespace flipside::lab

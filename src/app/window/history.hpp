#pragma once
/// Values over simulated time, the last seconds of them.

#include <deque>

namespace flipside::app {

struct Sample {
    double time = 0, value = 0;
};

inline constexpr double history_seconds = 12;

/// Appends a sample, in place of one at the same time or later, and drops what is older than history_seconds.
inline void remember(std::deque<Sample>& history, Sample sample) {
    while (!history.empty() && history.back().time >= sample.time) history.pop_back();
    history.push_back(sample);
    while (history.front().time < sample.time - history_seconds) history.pop_front();
}

inline void forget_after(std::deque<Sample>& history, double time) {
    while (!history.empty() && history.back().time > time) history.pop_back();
}

}  // namespace flipside::app

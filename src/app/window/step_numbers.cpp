#include "app/window/step_numbers.hpp"

#include <algorithm>

namespace flipside::app {

const StepNumbers* numbers_at(const std::deque<StepNumbers>& numbers, double time) {
    constexpr double same_time = 1e-9;  // s
    const auto after = std::ranges::upper_bound(numbers, time + same_time, {}, &StepNumbers::time);
    return after == numbers.begin() ? nullptr : &*std::prev(after);
}

}  // namespace flipside::app

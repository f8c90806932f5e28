#pragma once
/// Random numbers for properties.

#include <rapidcheck.h>

namespace flipside::custom::test {

/// One of a million and one equally spaced numbers from low to high.
inline double between(double low, double high) {
    return low + (high - low) * *rc::gen::inRange(0, 1'000'001) / 1e6;
}

}  // namespace flipside::custom::test

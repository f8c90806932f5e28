#pragma once
/// A median with how sure it is.

#include <vector>

namespace flipside::lab {

struct Median {
    double value = 0;
    /// Of a confidence interval of at least 95 %: order statistics, so for whatever distribution. Least and
    /// largest value where there are fewer than six.
    double low = 0, high = 0;
};
/// Needs at least one value, all of them numbers.
[[nodiscard]] Median median_of(std::vector<double> values);

}  // namespace flipside::lab

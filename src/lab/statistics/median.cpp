#include "lab/statistics/median.hpp"

#include <algorithm>

#include <boost/math/distributions/binomial.hpp>

namespace flipside::lab {

Median median_of(std::vector<double> values) {
    std::ranges::sort(values);
    const std::size_t n = values.size();
    // Of n values k or fewer lie below the true median with the probability of k heads or fewer in n throws.
    const boost::math::binomial throws(static_cast<double>(n), 0.5);
    std::size_t outside = 0;
    while (2 * (outside + 1) < n && cdf(throws, static_cast<double>(outside)) <= 0.025) ++outside;
    const std::size_t first = outside > 0 ? outside - 1 : 0;
    return {0.5 * (values[(n - 1) / 2] + values[n / 2]), values[first], values[n - 1 - first]};
}

}  // namespace flipside::lab

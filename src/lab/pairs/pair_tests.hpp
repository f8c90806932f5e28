#pragma once
/// The classic toy's experiment: how many box tests each broad phase needs to find the pairs of n balls,
/// for n = 2 … 32 under the toy's conditions, with the straight line through these counts; and how that
/// grows with n up to 100,000.
///
/// The conditions, with 1 px taken as 1 mm: balls of 42 px in 960 × 704 px, elastic, at 1000 px/s, no
/// gravity, 60 s at 60 Hz, quadtree of depth 4, so leaves of 60 × 44 px. One world moves the balls, and all
/// broad phases search the same boxes, those of the balls alone, once per step. Insertion counts.

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace flipside::lab {

/// Least squares of y over x; at least two different x.
struct LinearFit {
    double slope, intercept;
    double r_squared;  ///< 1 where y is constant
};
[[nodiscard]] LinearFit fit_line(const std::vector<double>& x, const std::vector<double>& y);

/// From how many balls on there are fewer tests than brute force's n(n−1)/2, `tests` being those for
/// n = first, first + 1, …; straight between two n. Nothing where there are more at the last n.
[[nodiscard]] std::optional<double> crossing_with_brute_force(int first, const std::vector<double>& tests);

struct PairTests {
    static constexpr int fewest = 2, most = 32;  ///< balls under the toy's conditions

    struct Row {
        std::string broad_phase;
        std::vector<double> tests;       ///< per search, mean over all steps, for n = fewest … most
        LinearFit line;                  ///< through `tests`
        std::optional<double> crossing;  ///< with brute force
    };
    /// Balls as dense as 32 are under the toy's conditions, uniformly at random, in straight flight.
    struct Growth {
        std::size_t balls;
        struct Cost {
            std::string broad_phase;
            double tests_per_ball;  ///< mean of the searches
            double ns_per_ball;     ///< CPU time, the least of the searches
        };
        std::vector<Cost> costs;  ///< brute force only while n is small
    };
    double seconds;
    std::vector<Row> rows;
    std::vector<Growth> growth;
};

/// `watch` is called after every step and search with the part done, 0 … 1. Takes about 1 s of CPU per
/// 10 s simulated, and 3 s for the growth up to 100,000 balls.
[[nodiscard]] PairTests count_pair_tests(double seconds = 60, std::size_t most_balls = 100'000,
                                         const std::function<void(double)>& watch = {});

[[nodiscard]] std::string to_json(const PairTests& found);

}  // namespace flipside::lab

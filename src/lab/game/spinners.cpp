#include "lab/game/spinners.hpp"

#include <algorithm>
#include <cmath>

namespace flipside::lab {

namespace {

/// A spinner loses speed evenly, so the root of the half turns still to come falls evenly: by this much
/// a second. 16 half turns take 2 s.
constexpr double spinner_drag = 2;

}  // namespace

void Spinners::pass(std::span<const Rules::Spinner> spinners, PartIndex part, double speed) {
    for (std::size_t i = 0; i < left_.size(); ++i)
        if (spinners[i].part == part) left_[i] += speed * spinners[i].turns_per_speed;
}

long Spinners::turn(std::span<const Rules::Spinner> spinners, double seconds) {
    long points = 0;
    for (std::size_t i = 0; i < left_.size(); ++i) {
        const double root = std::max(0.0, std::sqrt(left_[i]) - spinner_drag * seconds);
        const double still = root * root;
        points += std::lround(std::floor(left_[i]) - std::floor(still)) * spinners[i].points;
        left_[i] = still;
    }
    return points;
}

double Spinners::left(std::span<const Rules::Spinner> spinners, PartIndex part) const {
    double left = 0;
    for (std::size_t i = 0; i < left_.size(); ++i)
        if (spinners[i].part == part) left += left_[i];
    return left;
}

}  // namespace flipside::lab

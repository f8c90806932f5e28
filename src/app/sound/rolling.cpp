#include "app/sound/rolling.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "world/math.hpp"

namespace flipside::app::sound {

namespace {

constexpr double loudness = 0.018, loudest = 0.09;       ///< at 1 m/s, and at most; root mean square
constexpr double lowest = 60, higher = 90;               ///< Hz at rest, and more at 1 m/s
constexpr double fastest = 8;                            ///< m/s, from where on the pitch stays
constexpr double radius = 0.99;                          ///< of the poles: a broad band
constexpr double approach = 1.0 / (0.02 * sample_rate);  ///< per sample: a fiftieth of a second
constexpr double silence = 1e-6;

}  // namespace

void Rolling::add_to(std::span<Stereo> block) {
    const double target = std::min(loudness * roll_.speed, loudest);
    if (target == 0 && level_ < silence) {
        level_ = y1_ = y2_ = 0;
        return;
    }
    const double frequency = (lowest + higher * std::min(roll_.speed, fastest)) * roll_.pitch;
    const double cosine = math::cos(2 * std::numbers::pi * frequency / sample_rate);
    const Stereo gain = pan_gains(roll_.pan);
    // What comes out has a mean square of 1: the variance of white noise, 1/3, through the two poles.
    const double square = radius * radius, apart = 2 * square * (2 * cosine * cosine - 1);
    const double input = std::sqrt(3 * (1 - square) * (1 + square * square - apart) / (1 + square));
    for (Stereo& sample : block) {
        level_ += approach * (target - level_);
        noise_ = noise_ * 1664525U + 1013904223U;  // D. Knuth and H. Lewis, in Numerical Recipes
        const double white = static_cast<double>(noise_) * 0x1p-31 - 1;
        const double y = input * white + 2 * radius * cosine * y1_ - square * y2_;
        y2_ = std::exchange(y1_, y);
        sample.left += gain.left * level_ * y;
        sample.right += gain.right * level_ * y;
    }
}

}  // namespace flipside::app::sound

#pragma once
/// What the tests of sound ask of samples.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <span>
#include <vector>

#include "app/sound/mixer.hpp"

namespace flipside::app::sound {

using Samples = std::vector<std::int16_t>;

inline Samples rendered(Mixer& mixer, double seconds) {
    Samples samples(2 * static_cast<std::size_t>(seconds * sample_rate));
    mixer.render(samples);
    return samples;
}

inline int peak_of(std::span<const std::int16_t> samples) {
    int peak = 0;
    for (const int sample : samples) peak = std::max(peak, std::abs(sample));
    return peak;
}

/// Mean square of one side, 0 left or 1 right, over all.
inline double power_of(std::span<const std::int16_t> samples, std::size_t side) {
    double sum = 0;
    for (std::size_t i = side; i < samples.size(); i += 2) sum += double(samples[i]) * samples[i];
    return sum / (0.5 * static_cast<double>(samples.size()));
}

inline double power_of(std::span<const std::int16_t> samples) {
    return power_of(samples, 0) + power_of(samples, 1);
}

/// How strong a frequency is on the left, by its term of the Fourier sum.
inline double strength_at(std::span<const std::int16_t> samples, double frequency) {
    double re = 0, im = 0;
    for (std::size_t i = 0; i < samples.size(); i += 2) {
        const double phase = std::numbers::pi * frequency / sample_rate * static_cast<double>(i);
        re += samples[i] * std::cos(phase);
        im += samples[i] * std::sin(phase);
    }
    return std::hypot(re, im);
}

}  // namespace flipside::app::sound

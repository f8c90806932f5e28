#include "app/sound/voice.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "world/math.hpp"

namespace flipside::app::sound {

namespace {

constexpr double pi = std::numbers::pi;
constexpr double decays_heard = 7;         ///< after as many decays, −60 dB, a mode is over
constexpr double highest = 0.45;           ///< of the sample rate; modes above it are left out
constexpr double least_restitution = 0.3;  ///< what takes all of a ball's energy still rings a little

}  // namespace

Stereo pan_gains(double pan) {
    const auto [sine, cosine] = math::sincos((std::clamp(pan, -1.0, 1.0) + 1) * pi / 4);
    return {cosine, sine};
}

Voice::Voice(const Strike& strike, int delay)
    : gain_(pan_gains(strike.pan)), loudness_(loudness_of(strike)), delay_(std::max(0, delay)) {
    const double pitch = std::clamp(strike.pitch, 0.25, 4.0);
    pulse_ = std::max(2, static_cast<int>(sample_rate * contact_seconds(strike) / pitch));
    double longest = 0;
    const Timbre& timbre = timbre_of(strike.source);
    for (std::size_t i = 0; i < resonators_.size(); ++i) {
        const Mode& mode = timbre.modes[i];
        const double turn = mode.frequency * pitch / sample_rate;  // of a circle, per sample
        if (mode.gain == 0 || turn > highest) continue;
        const double decay = mode.decay / pitch * std::clamp(strike.restitution, least_restitution, 1.0);
        const double radius = 1 + math::expm1(-1 / (decay * sample_rate));
        const auto [sine, cosine] = math::sincos(2 * pi * turn);
        resonators_[i] = {mode.gain * sine * loudness_, 2 * radius * cosine, radius * radius, 0, 0};
        longest = std::max(longest, decay);
    }
    length_ = left_ = pulse_ + static_cast<int>(decays_heard * longest * sample_rate);
}

double Voice::level() const {
    if (length_ == 0) return 0;
    const double left = static_cast<double>(left_) / length_, square = left * left;
    return loudness_ * left * square * square;  // at first as fast as its longest mode decays
}

/// Its sum over the contact is 1.
double Voice::force(int sample) const {
    return 0.5 * pi / pulse_ * math::sin(pi * (sample + 0.5) / pulse_);
}

void Voice::add_to(std::span<Stereo> block) {
    const auto waits = std::min<std::size_t>(block.size(), static_cast<std::size_t>(delay_));
    delay_ -= static_cast<int>(waits);
    for (Stereo& sample : block.subspan(waits)) {
        if (left_ <= 0) return;
        const int now = length_ - left_--;
        const double x = now < pulse_ ? force(now) : 0;
        double sum = 0;
        for (Resonator& r : resonators_) {
            const double y = r.input * x + r.once * r.y1 - r.twice * r.y2;
            r.y2 = std::exchange(r.y1, y);
            sum += y;
        }
        sample.left += gain_.left * sum;
        sample.right += gain_.right * sum;
    }
}

}  // namespace flipside::app::sound

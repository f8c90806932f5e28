#pragma once
/// The sound of one hit: the force of the contact, half a sine in time, drives the modes of what is hit, each
/// a resonator with two poles. A harder hit has the greater force in the shorter time, so it is louder and
/// brighter.

#include <span>

#include "app/sound/timbre.hpp"

namespace flipside::app::sound {

inline constexpr int sample_rate = 44'100;  ///< Hz

/// Samples of both sides.
struct Stereo {
    double left = 0, right = 0;
};

class Voice {
  public:
    Voice() = default;
    /// It begins after `delay` samples.
    Voice(const Strike& strike, int delay);

    /// Adds its next samples, and goes on by as many. Cost: 5 resonators per sample.
    void add_to(std::span<Stereo> block);
    [[nodiscard]] int waits() const { return delay_; }  ///< samples until it begins
    [[nodiscard]] bool ended() const { return left_ <= 0; }
    /// Roughly how loud it still is, to tell voices apart.
    [[nodiscard]] double level() const;

  private:
    struct Resonator {
        double input = 0, once = 0, twice = 0;  ///< y = input·x + once·y₋₁ − twice·y₋₂
        double y1 = 0, y2 = 0;
    };

    [[nodiscard]] double force(int sample) const;

    std::array<Resonator, std::tuple_size_v<decltype(Timbre::modes)>> resonators_{};
    Stereo gain_;
    double loudness_ = 0;
    int delay_ = 0;
    int pulse_ = 0;   ///< samples of the contact
    int length_ = 0;  ///< samples until it cannot be heard
    int left_ = 0;    ///< of them
};

/// Shares of equal power for a place from −1 to 1.
[[nodiscard]] Stereo pan_gains(double pan);

}  // namespace flipside::app::sound

#pragma once
/// Random numbers, the same with every library.

#include <cstdint>
#include <numbers>
#include <random>

#include "world/vec2.hpp"

namespace flipside::lab {

class Dice {
  public:
    explicit Dice(std::uint64_t seed) : engine_(seed) {}
    /// Uniform in [0, limit).
    double below(double limit) { return limit * static_cast<double>(engine_() >> 11) * 0x1p-53; }
    double between(double low, double high) { return low + below(high - low); }
    Vec2 direction() { return from_angle(below(2 * std::numbers::pi)); }

  private:
    std::mt19937_64 engine_;
};

}  // namespace flipside::lab

#pragma once
/// Spinners: plates on an axle over the way, which a ball sets turning as it passes.

#include <span>
#include <vector>

#include "world/scene.hpp"

namespace flipside::lab {

class Spinners {
  public:
    explicit Spinners(std::size_t count) : left_(count) {}

    /// A ball passes a part at that speed, m/s.
    void pass(std::span<const Rules::Spinner> spinners, PartIndex part, double speed);
    /// Lets them turn for `seconds`; the points for that.
    long turn(std::span<const Rules::Spinner> spinners, double seconds);
    /// Half turns still to come.
    [[nodiscard]] double left(std::span<const Rules::Spinner> spinners, PartIndex part) const;

  private:
    std::vector<double> left_;  ///< per spinner: half turns still to come
};

}  // namespace flipside::lab

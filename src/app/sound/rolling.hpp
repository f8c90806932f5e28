#pragma once
/// The sound of rolling: noise through one resonator. The faster the balls, the louder and the higher.

#include <cstdint>
#include <span>

#include "app/sound/voice.hpp"

namespace flipside::app::sound {

/// Of all balls together.
struct Roll {
    double speed = 0;  ///< m/s, the root of the sum of their squares
    double pan = 0;    ///< −1 left … 1 right
    double pitch = 1;  ///< as in Strike
};

class Rolling {
  public:
    /// The sound comes to that within some hundredths of a second.
    void set(const Roll& roll) { roll_ = roll; }
    void add_to(std::span<Stereo> block);

  private:
    Roll roll_;
    double level_ = 0;
    double y1_ = 0, y2_ = 0;
    std::uint32_t noise_ = 1;
};

}  // namespace flipside::app::sound

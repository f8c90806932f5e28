#pragma once
/// Falling asleep. A ball sleeps from the end of a step over which it was slow and nothing drove it: what
/// it did in that one step decides, so there is no timer that a saved state would have to hold.

#include <span>
#include <vector>

#include "custom/broad_phase/room.hpp"
#include "world/ball.hpp"
#include "world/events.hpp"

namespace flipside::custom {

class Sleep {
  public:
    /// `speed` in m/s; `gravity` in m/s² is its amount.
    Sleep(double speed, double gravity) : speed_(speed), gravity_(gravity) {}

    /// Makes room for so many balls.
    void reserve(std::size_t balls) { make_room(before_, balls); }
    /// Before a step: remembers the balls.
    void watch(std::span<const Ball> balls);
    /// After it: puts those to sleep, with all velocity gone, that were slower than `speed` throughout and
    /// did not gain more than a thousandth of what gravity gives in free fall (a ball that turns back on
    /// a slope does). Balls that joined in between, and those that a contact squeezes by more than half a
    /// hundredth of their radius, are left alone.
    void settle(std::span<Ball> balls, std::span<const Contact> contacts, double dt);

  private:
    struct Before {
        BallNumber number = 0;
        Vec2 position, velocity;
        double radius = 0;  ///< m
        bool squeezed = false;
    };
    void squeeze(BallNumber number, double overlap);

    double speed_, gravity_;
    std::vector<Before> before_;
};

}  // namespace flipside::custom

#pragma once
/// Falling asleep. A ball sleeps when it has been at rest for a moment, so have all awake balls that it
/// touches, and all balls that carry it sleep. What they did in that one moment decides, so there is no timer
/// that a saved state would have to contact. A heap falls asleep ball by ball, from below.
///
/// Its approximation, *early rest*: a ball alone is stopped when slower than sleep_speed, balls in touch when
/// slower than a twentieth of what gravity gives in the moment: so much motion the contact solver leaves
/// where the true forces balance. What is driven by more than a thousandth of gravity (among balls in touch a
/// fiftieth, for balance is found no better there) is not at rest, however slow: a ball that turns back on a
/// slope, a heap that begins to slide. Nor is what nothing holds, with gravity or without: it sleeps only if
/// it does not move at all. Nor is what is squeezed by more than half a hundredth of its radius: it is on its
/// way out.

#include <cstdint>
#include <span>
#include <vector>

#include "world/ball.hpp"
#include "world/events.hpp"

namespace flipside::custom {

class Sleep {
  public:
    /// `speed` in m/s; `gravity` in m/s².
    Sleep(double speed, Vec2 gravity) : speed_(speed), gravity_(gravity) {}

    /// Makes room for so many balls.
    void reserve(std::size_t balls);
    /// Remembers the awake balls that may be at rest, `moment` seconds before settle().
    void watch(std::span<const Ball> balls, double moment);
    /// Puts balls to sleep, with all velocity gone, and wakes sleepers that an awake ball carries. `contacts`
    /// are all there are. Whether any fell asleep. Cost: O((balls + contacts) · log).
    bool settle(std::span<Ball> balls, std::span<const Contact> contacts);

  private:
    struct Before {
        BallNumber number = 0;
        Vec2 position, velocity;
    };
    /// What is found of a ball at the end of the moment.
    struct Finding {
        bool in_company = false;  ///< touches a ball
        bool squeezed = false;    ///< by a contact
        bool at_rest = false;     ///< or asleep
        bool calm = false;        ///< may sleep, or sleep on
    };
    /// One ball lies on another.
    struct Carried {
        double height = 0;  ///< of the lower one, m² /s²
        std::uint32_t lower = 0, upper = 0;
    };
    [[nodiscard]] double slow(bool in_company) const;
    [[nodiscard]] bool may_rest(const Ball& ball) const;
    [[nodiscard]] bool rested(const Before& before, const Ball& ball, bool in_company) const;
    void find_company(std::span<const Ball> balls, std::span<const Contact> contacts);
    void find_rest(std::span<const Ball> balls);
    void find_calm(std::span<const Ball> balls, std::span<const Contact> contacts);

    double speed_;
    Vec2 gravity_;
    double moment_ = 0;
    std::vector<Before> before_;     ///< by rising number
    std::vector<Finding> findings_;  ///< by index
    std::vector<Carried> carried_;
};

}  // namespace flipside::custom

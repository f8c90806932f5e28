#pragma once
/// Falling asleep. Balls that touch sleep together or not at all, from the end of a step over which they
/// were slow and nothing drove them: what they did in that one step decides, so there is no timer that a
/// saved state would have to hold.
///
/// Its approximation, *early rest*: a ball alone is stopped when slower than sleep_speed, balls in touch when
/// slower than a twentieth of what gravity gives in a step: so much motion the solver of piles leaves where
/// the true forces balance. What is driven by more than a thousandth of gravity (in company a fiftieth, for
/// balance is found no better there) is not at rest, however slow: a ball that turns back on a slope, a
/// pile that begins to slide. Nor is what nothing holds, with
/// gravity or without: it sleeps only if it does not move at all.

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
    void reserve(std::size_t balls);
    /// Before a step of dt: remembers the balls that may be at rest.
    void watch(std::span<const Ball> balls, double dt);
    /// After it: puts islands to sleep, with all velocity gone, none of whose balls moved, was driven,
    /// joined in between, or is squeezed by a contact by more than half a hundredth of its radius. An
    /// island is a ball or awake balls that touch. `contacts` are those of `balls`.
    /// Cost: O((balls + contacts) · log balls), nothing when all sleep.
    void settle(std::span<Ball> balls, std::span<const Contact> contacts, double dt);

  private:
    struct Before {
        BallNumber number = 0;
        Vec2 position, velocity;
    };
    struct Member {
        std::size_t island = 0;   ///< place of a ball of the same island, its own if it stands for it
        bool moves = false;       ///< of the ball that stands for an island: any in it moves or is squeezed
        bool in_company = false;  ///< touches a ball
    };
    void join(std::span<const Ball> balls, const Contact& contact);
    [[nodiscard]] std::size_t island_of(std::size_t i);
    [[nodiscard]] double slow(bool in_company, double dt) const;
    [[nodiscard]] double fast_squared(double dt) const;
    [[nodiscard]] bool moved(const Before& before, const Ball& ball, bool in_company, double dt) const;

    double speed_, gravity_;
    std::vector<Before> before_;
    std::vector<Member> members_;      ///< of the balls after the step
    std::vector<std::uint32_t> slow_;  ///< places of those that may be at rest
};

}  // namespace flipside::custom

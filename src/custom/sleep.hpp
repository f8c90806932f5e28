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

#include "custom/sift.hpp"
#include "world/ball.hpp"
#include "world/events.hpp"

namespace flipside::custom {

class Sleep {
  public:
    /// `speed` in m/s; `gravity` in m/s² is its amount.
    Sleep(double speed, double gravity) : speed_(speed), gravity_(gravity) {}

    /// Makes room for so many balls.
    void reserve(std::size_t balls);
    /// Before a step of dt: remembers the balls that may be at rest. It knows them from the step before, if
    /// nobody else has changed the balls since.
    void watch(std::span<const Ball> balls, double dt);
    void forget() { known_for_ = unknown; }
    /// After it, shows it every ball: begin_look(), then look() by rising place.
    void begin_look(std::size_t balls) {
        make_writable(slow_, balls);
        slow_count_ = 0;
    }
    void look(std::size_t place, const Ball& ball) {
        slow_[slow_count_] = static_cast<std::uint32_t>(place);
        slow_count_ += static_cast<std::size_t>(length_squared(ball.velocity) <= fast_);
    }
    /// Whether any may fall asleep now: without, settle() does nothing.
    [[nodiscard]] bool may_settle(std::span<const Ball> balls) const;
    /// Then puts islands to sleep, with all velocity gone, none of whose balls moved, was driven,
    /// joined in between, or is squeezed by a contact by more than half a hundredth of its radius. An
    /// island is a ball or awake balls that touch. `contacts` are those of `balls`. Whether any fell asleep.
    /// Cost: O((slow balls + contacts) · log balls), nothing when all sleep.
    bool settle(std::span<Ball> balls, std::span<const Contact> contacts, double dt);

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
    [[nodiscard]] std::span<const std::uint32_t> slow() const { return {slow_.data(), slow_count_}; }
    void find_islands(std::span<const Ball> balls, std::span<const Contact> contacts);
    void join(std::span<const Ball> balls, const Contact& contact);
    [[nodiscard]] std::size_t island_of(std::size_t i);
    [[nodiscard]] double slow(bool in_company, double dt) const;
    [[nodiscard]] double fast_squared(double dt) const;
    [[nodiscard]] bool moved(const Before& before, const Ball& ball, bool in_company, double dt) const;

    double speed_, gravity_;
    std::vector<Before> before_;
    std::vector<Member> members_;  ///< by place: of slow balls and of those in touch
    static constexpr double unknown = -1;
    double fast_ = 0;                  ///< m²/s², who is faster is surely not at rest after this step
    double known_for_ = unknown;       ///< slow_ holds those no faster than the root of this
    std::vector<std::uint32_t> slow_;  ///< places of those that may be at rest: so many of these
    std::size_t slow_count_ = 0;
};

}  // namespace flipside::custom

#pragma once
/// Sleep. A ball falls asleep when it and all awake balls that it touches were at rest during an interval,
/// and all balls that carry it sleep. Only this interval counts, so a saved state needs no sleep timer. A
/// heap falls asleep ball by ball, from below. A sleeping ball wakes beside a ball that moves, for the forces
/// on it change then.
///
/// Approximation, *early rest*: a single ball may sleep when it is slower than sleep_speed; balls in contact
/// when they are slower than a sixtieth of the speed that gravity gives in the interval, since the island
/// solver leaves that much motion in a heap in equilibrium. A ball that accelerates by more than a thousandth
/// of gravity (in contact with balls a twentieth, for the same reason) is not at rest, however slow it is: it
/// may turn back on a slope, or belong to a heap that begins to slide. A ball that nothing but gravity and
/// drag acts on is not at rest either, however slowly it sinks; without gravity, a ball sleeps only if it
/// does not move at all. A ball that overlaps anything by more than a hundredth of its radius does not sleep:
/// it is still pushed out.
///
/// Approximation, *sleepers carry any load*: a sleeping ball stands like a part. Slow balls that come to rest
/// on it later do not move it, though they might if it were awake.

#include <cstddef>
#include <span>
#include <vector>

#include "custom/continuous/resting_contact.hpp"
#include "world/ball.hpp"
#include "world/events.hpp"

namespace flipside::custom {

class Sleep {
  public:
    /// `speed` in m/s.
    Sleep(double speed, const ExternalForces& external)
        : speed_(speed), gravity_(external.gravity), drag_(external.drag) {}

    void reserve(std::size_t balls);
    /// Notes the awake balls that may be at rest, `interval` seconds before update().
    void watch(std::span<const Ball> balls, double interval);
    /// Puts balls to sleep, with zero velocity, and wakes sleeping balls that an awake ball carries or
    /// pushes. `contacts` are all contacts of the balls, up to sleep_distance. Returns whether any fell
    /// asleep or woke. Cost: O((balls + contacts) · log).
    bool update(std::span<Ball> balls, std::span<const Contact> contacts);

  private:
    /// State of a ball at the end of the interval.
    struct Finding {
        bool touches_ball = false;
        bool squeezed = false;   ///< overlaps something by more than squeezed_overlap
        bool at_rest = false;    ///< or already asleep
        bool may_sleep = false;  ///< or may stay asleep
    };
    /// A ball that lies on another.
    struct Carried {
        double height = 0;                 ///< of the lower one, m² /s²
        std::size_t lower = 0, upper = 0;  ///< indices of balls
    };
    [[nodiscard]] double speed_limit(bool touches_ball) const;
    [[nodiscard]] bool rested(const Ball& ball, bool touches_ball) const;
    void find_rest(std::span<const Ball> balls, std::span<const Contact> contacts);
    void find_sleepers(std::span<const Ball> balls, std::span<const Contact> contacts);

    double speed_;
    Vec2 gravity_;                   ///< m/s²
    double drag_;                    ///< 1/s
    double interval_ = 0;            ///< s
    std::vector<Ball> before_;       ///< that may be at rest, at the start of the interval
    std::vector<Finding> findings_;  ///< per ball
    std::vector<Carried> carried_;
};

}  // namespace flipside::custom

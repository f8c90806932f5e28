#pragma once
/// The impacts of a run, to be asked for afterwards.

#include <deque>
#include <optional>
#include <span>

#include "world/ball.hpp"
#include "world/events.hpp"

namespace flipside::lab {

/// An impact with the speed after it, which follows from its impulse.
struct Impact {
    Event event;
    /// m/s along the normal after the impact, in the frame of what was met; nothing where a ball of it was
    /// gone at the end of the step.
    std::optional<double> leaving;

    /// Restitution as it came about: leaving over approach.
    [[nodiscard]] std::optional<double> restitution() const {
        if (!leaving || event.speed <= 0) return std::nullopt;
        return *leaving / event.speed;
    }
};

/// Whether the ball or part has to do with the event.
[[nodiscard]] inline bool concerns(const Event& event, Other subject) {
    return event.other == subject || (subject.is_ball && event.ball == subject.index);
}

class ImpactLog {
  public:
    static constexpr double longest = 30;        ///< s that are kept
    static constexpr std::size_t most = 50'000;  ///< about 5 MB; then less than `longest` is kept

    /// The events of a step, in order of time, and the balls after it. Cost: impacts times log of the balls.
    void observe(std::span<const Event> events, std::span<const Ball> balls);
    void forget_after(double time);

    /// Until a time, s, the last impact, or the last one of a ball or part. Cost: linear in those after it.
    [[nodiscard]] std::optional<Impact> last(double until) const;
    [[nodiscard]] std::optional<Impact> last(Other subject, double until) const;
    /// The impact of the same pair nearest in time to `like`, at most `tolerance` s from it and until that
    /// time. Cost: linear in those after it.
    [[nodiscard]] std::optional<Impact> nearest(const Event& like, double tolerance, double until) const;

  private:
    std::deque<Impact> impacts_;  ///< by time of their step
};

}  // namespace flipside::lab

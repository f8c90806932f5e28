#pragma once
/// Notices balls that stay where they are.

#include <map>
#include <span>

#include "lab/game/game.hpp"

namespace flipside::lab::bot {

class StillWatch {
  public:
    static constexpr double stuck_after = 10;  ///< s
    static constexpr double region = 2;  ///< a ball is still while it is within so many radii of a place

    explicit StillWatch(std::shared_ptr<const Scene> scene) : scene_(std::move(scene)) {}

    /// After each step. Balls that wait at the launcher are not looked at.
    void look(double time, std::span<const Ball> balls);

    /// How often a ball was still for 10 s; one that stays counts once.
    [[nodiscard]] int stuck() const { return stuck_; }
    /// The longest time that a ball was still, s.
    [[nodiscard]] double longest() const { return longest_; }

  private:
    struct Stay {
        Vec2 place;
        double since;
        bool counted = false;
    };

    std::shared_ptr<const Scene> scene_;
    std::map<BallNumber, Stay> stays_;
    int stuck_ = 0;
    double longest_ = 0;
};

}  // namespace flipside::lab::bot

#pragma once
/// What a real table does when a ball is in play and no switch has closed for long: it works its coils one
/// after another until one does. Here: a ball that met nothing for a while is sought with the flippers, and
/// by shaking the table, a little harder each time round.

#include <span>
#include <vector>

#include "world/controls.hpp"
#include "world/events.hpp"

namespace flipside::lab {

class BallSearch {
  public:
    /// After each step. `patience` is Rules::ball_search; `held` says which flippers the player holds up:
    /// while one is, a ball may rest on it. Returns what the table does now.
    [[nodiscard]] std::vector<Control> look(std::span<const Event> events, std::span<const Ball> balls,
                                            const Scene& scene, const bool (&held)[2], double time);
    /// How often a search began.
    [[nodiscard]] int begun() const { return begun_; }

  private:
    struct Seen {
        BallNumber ball;
        double met;  ///< when it last met something, s
    };
    void follow(std::span<const Event> events, std::span<const Ball> balls, const Scene& scene, double time);
    void lower_flippers(std::vector<Control>& does, const bool (&held)[2]);
    void move(double time, std::vector<Control>& does);

    std::vector<Seen> seen_;
    int begun_ = 0;
    int moves_ = 0;         ///< of the search that is under way
    double next_move_ = 0;  ///< s
    double lower_at_ = -1;  ///< s; negative while the search holds no flipper up
};

}  // namespace flipside::lab

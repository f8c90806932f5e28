#pragma once
/// The game played on a table: score, ball count, lanes, targets, spinners, tilt. It reads events and
/// answers with controls, and knows no engine, so a rule cannot differ between engines.

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "world/controls.hpp"
#include "world/events.hpp"

namespace flipside::lab {

class Game {
  public:
    /// A scene without rules plays a game that only counts lost balls.
    explicit Game(std::shared_ptr<const Scene> scene);

    /// What a player asks for, as far as the rules let it through: no launch when the game is over or a
    /// ball is in play, no flippers after a tilt. Scripts do not ask.
    [[nodiscard]] bool permits(const Control& control) const;
    /// Tells the rules of a control that was applied (nudges count towards a tilt, launches start ball save).
    void applied(const Control& control, double time);
    /// Reads one step's events; returns the controls that the rules issue now, to be applied at once.
    /// `balls_in_play` is the number of balls in the world.
    [[nodiscard]] std::vector<Control> observe(std::span<const Event> events, double time,
                                               std::size_t balls_in_play);

    [[nodiscard]] long score() const { return score_; }
    [[nodiscard]] int balls_left() const { return balls_left_; }  ///< not counting those in play
    [[nodiscard]] bool over() const { return over_; }
    [[nodiscard]] bool tilted() const { return tilted_; }
    [[nodiscard]] bool lit(PartIndex lane) const;  ///< a rollover that was hit since its group's last reset
    [[nodiscard]] double spinning(PartIndex spinner) const;  ///< half turns still to come
    [[nodiscard]] long lost() const { return lost_; }        ///< balls reported lost since the start

  private:
    std::shared_ptr<const Scene> scene_;
    long score_ = 0;
    long lost_ = 0;
    int balls_left_ = 0;
    bool over_ = false;
    bool tilted_ = false;
};

}  // namespace flipside::lab

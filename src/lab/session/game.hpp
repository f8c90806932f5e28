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

    /// What a player asks for, as far as the rules let it through: a launch only while balls are left and
    /// every ball in the world waits at the launcher, no raising of flippers after a tilt. Scripts do not
    /// ask.
    [[nodiscard]] bool permits(const Control& control, std::span<const Ball> balls) const;
    /// Tells the rules of a control that was applied (nudges count towards a tilt, launches start ball save).
    void applied(const Control& control, double time);
    /// Reads one step's events; returns the controls that the rules issue now, to be applied at once.
    /// `balls_in_play` is the number of balls in the world.
    [[nodiscard]] std::vector<Control> observe(std::span<const Event> events, double time,
                                               std::size_t balls_in_play);

    /// The world was put into another state: the balls in it were there before, none was launched.
    void resume(std::size_t balls_in_play, double time);

    [[nodiscard]] long score() const { return score_; }
    [[nodiscard]] int balls_left() const { return balls_left_; }  ///< not counting those in play
    [[nodiscard]] bool over() const { return over_; }
    [[nodiscard]] bool tilted() const { return tilted_; }
    /// A rollover that was hit since its group's last reset.
    [[nodiscard]] bool lit(PartIndex lane) const { return hit_[lane]; }
    [[nodiscard]] double spinning(PartIndex spinner) const;    ///< half turns still to come
    [[nodiscard]] long lost() const { return lost_; }          ///< balls reported lost since the start
    [[nodiscard]] long launched() const { return launched_; }  ///< balls that entered since the start

  private:
    /// What a ball's hit of a part, or its way over a sensor, means.
    void hit(PartIndex part, double speed);
    /// Lets the spinners turn for `seconds`.
    void spin(double seconds);
    void count_balls(std::size_t balls_in_play, int lost_now);
    /// Pays the bonus of every group that is complete; returns those groups.
    std::vector<const Rules::Group*> complete(std::span<const Rules::Group> groups);
    void score(long points) {
        if (!tilted_) score_ += points;
    }

    std::shared_ptr<const Scene> scene_;
    Rules rules_;                 ///< the scene's, or none that score
    std::vector<int> points_;     ///< per part
    std::vector<bool> hit_;       ///< per part: a lane that is lit, a target that is down
    std::vector<double> spins_;   ///< per spinner of the rules: half turns still to come
    std::vector<double> nudges_;  ///< times of the last ones
    std::size_t in_play_ = 0;
    /// Those of them that belong to the game: a launch of many puts more on the table than it has, and only
    /// so many can be saved.
    int own_in_play_ = 0;
    double time_ = 0;
    double save_until_ = -1;
    long score_ = 0;
    long lost_ = 0;
    long launched_ = 0;
    int balls_left_ = 0;
    bool over_ = false;
    bool tilted_ = false;
    bool drop_flippers_ = false;  ///< the tilt has yet to let them fall
};

}  // namespace flipside::lab

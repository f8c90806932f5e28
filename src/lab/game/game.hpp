#pragma once
/// The game played on a table: its score, and what comes of the hits, the controls and the lost balls. It
/// reads events and answers with controls, and knows no engine, so a rule cannot differ between engines.
/// Turns, groups of parts, spinners, tilt and ball search are files of their own; this one lets them play
/// together.

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "lab/game/ball_search.hpp"
#include "lab/game/caption.hpp"
#include "lab/game/part_groups.hpp"
#include "lab/game/spinners.hpp"
#include "lab/game/tilt.hpp"
#include "lab/game/turns.hpp"
#include "world/state.hpp"

namespace flipside::lab {

class Game {
  public:
    /// A scene without rules plays a game that only counts lost balls.
    explicit Game(std::shared_ptr<const Scene> scene);

    /// What a player asks for, as far as the rules let it through: a launch only of a ball that lies at the
    /// plunger, or while turns are left on an empty table; no raising of flippers after a tilt. Scripts do
    /// not ask.
    [[nodiscard]] bool permits(const Control& control, std::span<const Ball> balls) const;
    /// Tells the rules of a control that was applied from outside.
    void applied(const Control& control, double time);
    /// Reads one step's events; returns the controls that the rules issue now, to be applied at once.
    /// `balls` are those in the world.
    [[nodiscard]] std::vector<Control> observe(std::span<const Event> events, double time,
                                               std::span<const Ball> balls);

    /// The world was put into another state: the balls in it were there before, none was launched.
    void resume(const State& state);

    [[nodiscard]] long score() const { return score_; }
    [[nodiscard]] const Turns& turns() const { return turns_; }
    [[nodiscard]] int balls_left() const { return turns_.left(); }  ///< not counting those in play
    [[nodiscard]] bool over() const { return over_; }
    [[nodiscard]] bool tilted() const { return tilt_.tilted(); }
    /// A rollover or target that was hit since its group's last reset.
    [[nodiscard]] bool lit(PartIndex part) const { return groups_.is_hit(part); }
    /// Whether that group of targets was down, and so counts towards the next multiball.
    [[nodiscard]] bool bank_done(std::size_t group) const { return banks_done_[group]; }
    /// The rollover that pays the skill shot now.
    [[nodiscard]] std::optional<PartIndex> skill_shot() const;
    [[nodiscard]] double spinning(PartIndex spinner) const;  ///< half turns still to come
    [[nodiscard]] long lost() const { return turns_.lost(); }
    [[nodiscard]] long launched() const { return turns_.launched(); }
    /// What the ball in play has collected, and how often that is paid when it is lost.
    [[nodiscard]] long end_bonus() const { return end_bonus_; }
    [[nodiscard]] int times() const { return times_; }
    [[nodiscard]] int searches() const { return search_.begun(); }
    /// The last ones, oldest first.
    [[nodiscard]] const std::vector<Caption>& captions() const { return captions_; }
    /// How many there have been, those that are not kept among them.
    [[nodiscard]] std::size_t told() const { return told_; }

  private:
    /// What a ball's hit of a part, or its way over a sensor, means.
    void hit(PartIndex part, double speed);
    void hit_in_group(PartIndex part);
    void raise(Side side);
    void complete_lanes();
    void complete_targets(std::vector<Control>& answer);
    void count_balls(int lost, std::size_t balls);
    void end_turn();
    void bring_balls(std::span<const Ball> balls, std::vector<Control>& answer);
    void score(long points) {
        if (!tilt_.tilted()) score_ += points;
    }
    [[nodiscard]] bool scores(PartIndex part) const;
    void tell(CaptionKind kind, long value = 0, long of = 0);

    std::shared_ptr<const Scene> scene_;
    std::shared_ptr<const Rules> rules_;  ///< the scene's, or some that score nothing
    struct Points {
        int now = 0, end = 0;  ///< to the score, and to the bonus at the turn's end
    };
    std::shared_ptr<const std::vector<Points>> points_;  ///< per part
    PartGroups groups_;
    Spinners spinners_;
    Tilt tilt_;
    Turns turns_;
    BallSearch search_;
    std::vector<bool> banks_done_;  ///< per group of targets
    std::size_t skill_ = 0;         ///< place in the skill shot's parts
    bool skill_open_ = true;        ///< the ball of this turn has not scored yet
    long end_bonus_ = 0;
    int times_ = 1;
    double time_ = 0;
    long score_ = 0;
    bool over_ = false;
    bool held_[2] = {false, false};  ///< flippers that were raised from outside, by Side
    bool drop_flippers_ = false;     ///< the tilt has yet to let them fall
    std::vector<Caption> captions_;
    std::size_t told_ = 0;
};

}  // namespace flipside::lab

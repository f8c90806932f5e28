#pragma once
/// Counts balls: the turns of a game, which of the balls on the table belong to it, which are saved, and
/// those that the table brings itself. A turn lasts from a launch until no ball of the game is left on the
/// table.

#include <algorithm>
#include <cstddef>

namespace flipside::lab {

class Turns {
  public:
    /// A game of so many turns; `ball_save` as in Rules. `in_play` balls lie there at the start.
    Turns(int turns, double ball_save, std::size_t in_play)
        : turns_(turns), left_(turns), ball_save_(ball_save), in_play_(static_cast<long>(in_play)) {}

    /// A launch that came from outside the rules.
    void launched(double time) {
        if (fresh_) save_until_ = time + ball_save_;
    }
    /// The ball of this turn has scored: its ball save runs on, and no later launch begins another.
    void scored() { fresh_ = false; }
    /// The world was put into another state, with so many balls, and launches that wait.
    void resume(std::size_t balls, std::size_t waiting);
    /// The table is to bring balls until the game has `balls` in play. Drained ones are brought again for
    /// as long as a ball save lasts.
    void start_multiball(int balls, double time);
    /// Nothing is saved any more in this turn, and nothing brought.
    void forfeit();

    /// Whether the table is to fire a ball now. Then tell it that it did.
    [[nodiscard]] bool is_due(double time) const { return to_bring_ > 0 && time >= next_bring_; }
    void brought(double time);
    /// Balls that the table fired, or is to fire, have yet to enter.
    [[nodiscard]] bool bringing() const { return to_bring_ + coming_ > 0; }

    struct Change {
        int saved = 0;       ///< balls of the game that drained in time
        bool again = false;  ///< the player launches them again, otherwise the table does
        bool ended = false;  ///< the turn
    };
    /// After a step with so many balls on the table; `lost` were reported, of which `gone` are not there any
    /// more.
    Change count(std::size_t balls, int lost, int gone, double time);

    [[nodiscard]] int left() const { return left_; }  ///< turns not begun yet
    /// The turn that is under way, or else the next one, from 1.
    [[nodiscard]] int number() const;
    [[nodiscard]] int turns() const { return turns_; }
    [[nodiscard]] bool multiball() const { return multiball_; }
    /// Whether a ball that drains now is saved.
    [[nodiscard]] bool saves(double time) const { return time <= save_until_; }
    [[nodiscard]] bool any_in_play() const { return in_play_ > 0; }
    [[nodiscard]] long lost() const { return lost_; }          ///< reported since the start
    [[nodiscard]] long launched() const { return launched_; }  ///< entered since the start

  private:
    void enter(long entered);
    void lose(int lost, double time, Change& change);

    int turns_, left_;
    double ball_save_;        ///< s
    long in_play_;            ///< balls on the table
    long own_ = 0;            ///< those of them that belong to the game: a player may launch more than it has
    int to_bring_ = 0;        ///< balls that the table is to fire
    int coming_ = 0;          ///< those that it fired and that have not entered yet
    double next_bring_ = 0;   ///< s
    double save_until_ = -1;  ///< s
    bool fresh_ = true;       ///< nothing has been scored or saved in this turn
    bool open_ = false;       ///< a turn is under way
    bool again_ = false;      ///< a saved ball of it waits to be launched
    bool multiball_ = false;
    long lost_ = 0, launched_ = 0;
};

}  // namespace flipside::lab

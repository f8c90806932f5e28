#pragma once
/// A player that sees the table as a person does and works the buttons that a person has. It sees where every
/// ball was a reaction time ago and how it moved then, takes it to have flown on freely since, and raises a
/// flipper when the ball should be in reach of it; it misjudges each ball a little. A bounce within its
/// reaction time takes it by surprise.

#include <deque>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "lab/game/game.hpp"
#include "lab/scenes/dice.hpp"
#include "world/table.hpp"

namespace flipside::lab::bot {

/// Visual reaction times of adults are 0.18…0.25 s; a player who waits for a ball is at the lower end
/// (Woodworth and Schlosberg 1954, "Experimental Psychology", ch. 2).
inline constexpr double reaction = 0.18;  ///< s
/// Spread of the moment at which people meet what they see coming, s: 20…40 ms in such tasks.
inline constexpr double misjudged = 0.03;

class Player {
  public:
    /// The same seed plays the same game. The scene has a launcher.
    Player(std::shared_ptr<const Scene> scene, std::uint64_t seed);

    /// What the player does now, with these balls before its eyes. To be called before each step.
    [[nodiscard]] std::vector<Control> act(double time, std::span<const Ball> balls, const Game& game);

  private:
    /// A flipper and the hand that works it.
    struct Finger {
        shape::Flipper flipper;
        Side side = Side::left;
        Vec2 along, up;           ///< units: from pivot to tip at rest; towards where it is raised to
        double aim = 0;           ///< distance from the pivot at which the next ball shall be hit, m
        double release_at = -1;   ///< s; negative while it is down
        double busy_until = 0;    ///< s
        double misjudgement = 0;  ///< s, of the next ball
    };
    struct Observation {
        double time;
        std::vector<Ball> balls;
    };

    void aim(Finger& finger);
    /// Where the ball is by now, as the player believes.
    [[nodiscard]] Ball believed(const Ball& seen, double since) const;
    [[nodiscard]] static bool in_reach(const Finger& finger, const Ball& ball);
    void flip(double time, std::vector<Control>& does);
    void save_by_nudge(double time, std::vector<Control>& does);
    void plunge(double time, std::span<const Ball> balls, const Game& game, std::vector<Control>& does);

    std::shared_ptr<const Scene> scene_;
    Dice dice_;
    std::vector<Finger> fingers_;
    std::deque<Observation> seen_;  ///< what is still younger than the reaction time, and one before that
    std::optional<double> fires_;   ///< when the ball on the plunger will be fired, s
    double nudges_again_ = 0;       ///< s
};

}  // namespace flipside::lab::bot

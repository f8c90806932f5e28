#pragma once
/// The end of a game: what it came to on each engine, and where these went different ways.

#include <string>
#include <vector>

#include "app/window/canvas.hpp"
#include "app/window/high_scores.hpp"
#include "app/window/layout.hpp"
#include "app/window/stage.hpp"

namespace flipside::app {

struct GameEnd {
    struct Score {
        std::string name;
        sf::Color color;
        long points = 0;
        bool best = false;    ///< of several, none of which has more
        bool enters = false;  ///< among the high scores
    };
    std::vector<Score> scores;    ///< one per run
    std::string parted;           ///< in a sentence; "" with a single run
    std::vector<HighScore> high;  ///< of this scene, best first
};

/// Whether the game is over on every run that has not halted. One that is over waits for the others.
[[nodiscard]] bool is_over(const Stage& stage);
/// A game has begun and is not over.
[[nodiscard]] bool is_game_under_way(const Stage& stage);
/// Without high scores.
[[nodiscard]] GameEnd end_of(const Stage& stage);
/// A game enters the high scores where nothing but keys played it, on the scene as it is, without going back.
/// The reference's games are no less games.
void enter_scores(const Stage& stage, HighScores& scores, GameEnd& end);

/// In the middle of all panes.
void draw_game_end(Canvas& canvas, const Layout& layout, const GameEnd& end);

}  // namespace flipside::app

#pragma once
/// A game by all rules on a table of six parts, which is fed with events, without an engine.

#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "lab/game/game.hpp"

namespace flipside::lab {

inline constexpr PartIndex bumper = 0, lane_a = 1, lane_b = 2, target_a = 3, target_b = 4, spinner = 5;

inline Scene scene_with_rules() {
    Scene scene;
    scene.parts.resize(6);
    Launcher launcher;
    launcher.position = {1, 0};
    launcher.plunger = true;
    scene.launcher = launcher;
    Rules rules;
    rules.balls = 2;
    rules.ball_save = 5;
    rules.tilt_nudges = 3;
    rules.tilt_seconds = 2;
    rules.scores = {{bumper, 100}, {lane_a, 5}, {target_a, 20}};
    rules.ball_search = 4;
    rules.lanes = {{{lane_a, lane_b}, 1000, true}};
    rules.skill_shot = {{lane_a, lane_b}, 700};
    rules.multiball = {3, 0.5, 4000};
    rules.end_bonus = {{{target_a, 200}, {target_b, 300}}, 3};
    rules.targets = {{{target_a, target_b}, 500}};
    rules.spinners = {{spinner, 10, 8}};
    scene.rules = rules;
    return scene;
}

inline Event hit(PartIndex part, double speed = 1) {
    return {0, EventKind::impact, 0, Other::part(part), {}, {}, speed, 0};
}
inline Event lost() {
    return {0, EventKind::lost, 0, {}, {}, {}, 0, 0};
}

class GameRules : public ::testing::Test {
  protected:
    explicit GameRules(Scene scene = scene_with_rules())
        : game(std::make_shared<const Scene>(std::move(scene))) {}

    Game game;
    double time = 0;
    std::vector<Ball> balls;

    /// Steps of 0.01 s at most, the events in the first one.
    std::vector<Control> see(std::vector<Event> events, double seconds = 0.01) {
        return game.observe(events, time += seconds, balls);
    }
    void enter(int count = 1) {
        for (int i = 0; i < count; ++i) {
            Ball ball;
            ball.radius = 0.01;
            ball.number = next++;
            balls.push_back(ball);
        }
    }
    void launch() {
        game.applied(control::Launch{}, time);
        enter();
        see({});
    }
    std::vector<Control> drain() {
        balls.pop_back();
        return see({lost()});
    }
    [[nodiscard]] const Caption& last() const { return game.captions().back(); }

  private:
    BallNumber next = 0;
};

}  // namespace flipside::lab

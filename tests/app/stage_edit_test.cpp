/// Balls thrown, added and taken away by hand, on all contenders of a stage.

#include <gtest/gtest.h>

#include "app/window/stage.hpp"

namespace flipside::app {
namespace {

namespace edit = lab::edit;

std::span<const Ball> balls_of(const Run& run) {
    return run.session().world().balls();
}

class StageEdit : public testing::Test {
  protected:
    StageEdit() { stage.run_until(0.2); }
    [[nodiscard]] Ball ball_at(Vec2 place) const {
        Ball ball = balls_of(stage.runs()[0])[0];
        ball.position = place;
        return ball;
    }

    Stage stage{"drop", "custom", View::split, {}, {}, {"ours=custom", "b=box2d", "exact=reference"}};
};

TEST_F(StageEdit, IsTheSameOnAllContenders) {
    ASSERT_TRUE(stage.edit(edit::Throw{0, {0.5, 2}}));
    ASSERT_TRUE(stage.edit(edit::Add{ball_at({0.3, 0.5})}));
    for (const auto& run : stage.runs()) {
        EXPECT_EQ(balls_of(run)[0].velocity, (Vec2{0.5, 2})) << run.name();
        ASSERT_EQ(balls_of(run).size(), 2U) << run.name();
        EXPECT_EQ(balls_of(run)[1].number, 1U) << run.name();
    }
    ASSERT_TRUE(stage.edit(edit::Remove{0}));
    for (const auto& run : stage.runs()) EXPECT_EQ(balls_of(run).front().number, 1U) << run.name();
    EXPECT_FALSE(stage.edit(edit::Remove{0}));
}

TEST_F(StageEdit, PutsNoBallWhereOneContenderHasNoRoom) {
    EXPECT_FALSE(stage.edit(edit::Add{ball_at({0.5, 0.01})}));  // in the floor
    EXPECT_FALSE(stage.edit(edit::Add{ball_at({1.5, 0.5})}));   // out of bounds
    EXPECT_FALSE(stage.edit(edit::Add{balls_of(stage.runs()[1])[0]}));
    // Box2D's ball has fallen further; just below it there is room on the other tables.
    const Ball lowest = balls_of(stage.runs()[1])[0];
    const Vec2 below = lowest.position - Vec2{0, 1.9 * lowest.radius};
    ASSERT_GT(balls_of(stage.runs()[0])[0].position.y, below.y + 2 * lowest.radius);
    EXPECT_FALSE(stage.edit(edit::Add{ball_at(below)}));
    for (const auto& run : stage.runs()) EXPECT_EQ(balls_of(run).size(), 1U);
}

TEST_F(StageEdit, IsUndoneByGoingBackBeforeItAndDoneAgainByGoingForth) {
    stage.run_until(0.1);
    const double then = stage.time();
    const Ball ball = ball_at({0.3, 0.5});
    ASSERT_TRUE(stage.edit(edit::Remove{0}));
    ASSERT_TRUE(stage.edit(edit::Add{ball}));
    stage.run_until(0.1);
    const std::vector<Ball> after(balls_of(stage.runs()[0]).begin(), balls_of(stage.runs()[0]).end());
    const double end = stage.time();
    stage.go_to(then - stage.dt());
    for (const auto& run : stage.runs()) {
        ASSERT_EQ(balls_of(run).size(), 1U);
        EXPECT_EQ(balls_of(run)[0].number, 0U);
    }
    stage.go_to(end);
    EXPECT_TRUE(std::ranges::equal(balls_of(stage.runs()[0]), after));
    stage.go_to(then - stage.dt());
    stage.run_until(0.2);
    for (const auto& run : stage.runs()) EXPECT_EQ(balls_of(run)[0].number, 0U);
}

TEST_F(StageEdit, InThePastForgetsWhatCameLater) {
    stage.go_to(0.1);
    ASSERT_TRUE(stage.in_past());
    ASSERT_TRUE(stage.edit(edit::Throw{0, {0.5, 2}}));
    EXPECT_FALSE(stage.in_past());
    EXPECT_EQ(stage.record_end(), stage.time());
}

TEST_F(StageEdit, ThatCannotBeKeepsWhatCameLater) {
    stage.go_to(0.1);
    EXPECT_FALSE(stage.edit(edit::Remove{5}));
    EXPECT_TRUE(stage.in_past());
}

TEST_F(StageEdit, GivesTheSameRunAgain) {
    Stage other{"drop", "custom", View::split, {}, {}, {"ours=custom", "b=box2d", "exact=reference"}};
    other.run_until(0.2);
    const Ball ball = ball_at({0.3, 0.5});
    for (Stage* each : {&stage, &other}) {
        each->edit(edit::Throw{0, {0.5, 2}});
        each->edit(edit::Add{ball});
        each->run_until(1);
    }
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_TRUE(std::ranges::equal(balls_of(stage.runs()[i]), balls_of(other.runs()[i])));
}

TEST_F(StageEdit, ASceneThatWasDrawnIsStartedOnAllContenders) {
    ASSERT_TRUE(stage.is_from_file());
    auto drawn = std::make_shared<Scene>(stage.scene());
    drawn->balls[0].position = {0.25, 1};
    stage.take("drop", drawn);
    EXPECT_EQ(stage.time(), 0);
    for (const auto& run : stage.runs()) EXPECT_EQ(balls_of(run)[0].position, (Vec2{0.25, 1})) << run.name();
    ASSERT_EQ(stage.runs().size(), 3U);
    // One that is in no file yet: its contenders are those of before.
    stage.take("", drawn);
    EXPECT_FALSE(stage.is_from_file());
    EXPECT_EQ(stage.runs().size(), 3U);
    EXPECT_EQ(stage.runs()[1].name(), "b");
    stage.open("drop");
    EXPECT_TRUE(stage.is_from_file());
}

}  // namespace
}  // namespace flipside::app

#include "world/table.hpp"

#include <numbers>

#include "world/refusal.hpp"
#include "world/support.hpp"

namespace flipside {
namespace {

using std::numbers::pi;
constexpr PartIndex wall = 0, bat = 1, fan = 2, gate = 3, drop_1 = 4, drop_2 = 5;

Table table(bool plunger = false) {
    Scene scene = scene_with_everything();
    scene.launcher->plunger = plunger;
    return Table(std::make_shared<const Scene>(std::move(scene)));
}

TEST(Table, FlipperRisesAtItsRateStopsDeadAndFalls) {
    // 60° up at 20 rad/s, down at 10 rad/s.
    const double full = pi / 3;
    Table t = table();
    EXPECT_EQ(t.rate(bat), 0);
    EXPECT_EQ(t.until_stop(bat), std::numeric_limits<double>::infinity());
    t.apply(control::Flip{Side::right, true});
    EXPECT_EQ(t.rate(bat), 0);
    t.apply(control::Flip{Side::left, true});
    EXPECT_EQ(t.rate(bat), 20);
    EXPECT_DOUBLE_EQ(t.until_stop(bat), full / 20);
    EXPECT_DOUBLE_EQ(t.pose(bat, 0.01).angle, 0.2);
    EXPECT_EQ(t.rate(bat, 0.01), 20);
    EXPECT_EQ(t.rate(bat, t.until_stop(bat)), 0);
    EXPECT_EQ(t.pose(bat, 1).angle, t.pose(bat, 2).angle);

    t.advance(0.02);
    EXPECT_DOUBLE_EQ(t.parts()[bat].angle, 0.4);
    EXPECT_DOUBLE_EQ(t.until_stop(bat), full / 20 - 0.02);
    t.advance(1);
    EXPECT_DOUBLE_EQ(t.parts()[bat].angle, full);
    EXPECT_EQ(t.rate(bat), 0);
    t.apply(control::Flip{Side::left, false});
    EXPECT_EQ(t.rate(bat), -10);
    EXPECT_DOUBLE_EQ(t.until_stop(bat), full / 10);
    t.advance(0.05);
    EXPECT_DOUBLE_EQ(t.parts()[bat].angle, full - 0.5);
    t.advance(1);
    EXPECT_EQ(t.parts()[bat].angle, 0);
}

TEST(Table, PoseTurnsPointsAboutThePivotAndBack) {
    const Pose pose{{0.5, 0}, pi / 2};
    EXPECT_NEAR(length(pose.apply({0.6, 0}) - Vec2{0.5, 0.1}), 0, 1e-15);
    EXPECT_NEAR(length(pose.undo(pose.apply({0.7, -3})) - Vec2{0.7, -3}), 0, 1e-14);
    EXPECT_EQ((Pose{{0.5, 0}, 0}.apply({0.1, 0.2})), (Vec2{0.1, 0.2}));
}

TEST(Table, TurningPartsTurnWhileRotationIsOn) {
    Table t = table();
    t.advance(1);
    EXPECT_EQ(t.parts()[fan].angle, 0);
    t.apply(control::Rotate{true});
    EXPECT_EQ(t.rate(fan), 3);
    t.advance(0.5);
    EXPECT_DOUBLE_EQ(t.pose(fan).angle, 1.5);
    EXPECT_EQ(t.pose(fan).pivot, (Vec2{0, 0.5}));
    t.apply(control::Rotate{false});
    t.advance(0.5);
    EXPECT_DOUBLE_EQ(t.pose(fan).angle, 1.5);
    EXPECT_EQ(t.rate(wall), 0);
}

TEST(Table, TargetsRiseAllOrByName) {
    Table t = table();
    t.set_down(drop_1, true);
    t.set_down(drop_2, true);
    t.apply(control::RaiseTargets{{drop_2}});
    EXPECT_TRUE(t.parts()[drop_1].down);
    EXPECT_FALSE(t.parts()[drop_2].down);
    t.apply(control::RaiseTargets{});
    EXPECT_FALSE(t.parts()[drop_1].down);
}

TEST(Table, LaunchSpeedFollowsStrengthAndSizeScalesTheBall) {
    Table t = table();
    t.apply(control::Launch{0.25, 1, 2});
    EXPECT_TRUE(t.launch_waiting());
    const auto launched = t.launch({});
    ASSERT_TRUE(launched);
    EXPECT_FALSE(launched->existing);
    EXPECT_EQ(launched->ball.position, (Vec2{0.9, -0.9}));
    EXPECT_NEAR(length(launched->ball.velocity - Vec2{0, 1.5}), 0, 1e-15);
    EXPECT_DOUBLE_EQ(launched->ball.radius, 0.02);
    EXPECT_DOUBLE_EQ(launched->ball.mass, 0.64);
    EXPECT_FALSE(t.launch_waiting());
    EXPECT_FALSE(t.launch({}));
}

TEST(Table, BurstWaitsUntilBallsAreARadiusApart) {
    Table t = table();
    t.apply(control::Launch{1, 2, 1});
    std::vector<Ball> balls = {t.launch({})->ball};
    EXPECT_FALSE(t.launch(balls));
    // Gap of one radius: centres three radii apart.
    t.advance(1.0 / 240);
    balls[0].position = Vec2{0.9, -0.9 + 0.0299};
    EXPECT_FALSE(t.launch(balls));
    t.advance(1.0 / 240);
    balls[0].position = Vec2{0.9, -0.9 + 0.03 * (1 - 1e-15)};
    EXPECT_TRUE(t.launch(balls));
    EXPECT_FALSE(t.launch_waiting());
}

TEST(Table, ALauncherLooksAtOnceAndThen240TimesASecond) {
    EXPECT_DOUBLE_EQ(next_look(0), 1.0 / 240);
    EXPECT_DOUBLE_EQ(next_look(7.0 / 240 - 1e-12), 8.0 / 240);
    EXPECT_DOUBLE_EQ(next_look(7.0 / 240 + 1e-12), 8.0 / 240);
    EXPECT_DOUBLE_EQ(next_look(1e5 + 0.5 / 240), 1e5 + 1.0 / 240);
    Table t = table();
    t.advance(0.001);
    t.apply(control::Launch{1, 1, 1});
    Ball in_the_way = t.scene().launcher->ball;
    in_the_way.position = {0.9, -0.9};
    EXPECT_FALSE(t.launch({&in_the_way, 1}));
    EXPECT_DOUBLE_EQ(t.save({}).next_look, 1.0 / 240);
    t.advance(0.003);
    EXPECT_FALSE(t.launch({})) << "its place is free, and the launcher does not look yet";
    t.advance(1.0 / 240 - 0.004);
    EXPECT_TRUE(t.launch({}));
    EXPECT_EQ(t.save({}).next_look, 0);
    t.advance(0.0001);
    t.apply(control::Launch{1, 1, 1});
    EXPECT_TRUE(t.launch({})) << "at once";
}

TEST(Table, PlungerFiresTheBallThatLiesThereWhateverElseIsNear) {
    Table t = table(true);
    Ball lying = t.scene().launcher->ball;
    lying.number = 7;
    lying.position = {0.9, -0.895};
    lying.spin = 3;
    lying.asleep = true;
    Ball waiting = lying;  // behind it in the lane, and before it in the list
    waiting.number = 2;
    waiting.position = {0.9, -0.875};
    t.apply(control::Launch{1, 1, 1});
    const auto launched = t.launch(std::vector{waiting, lying});
    ASSERT_TRUE(launched);
    EXPECT_TRUE(launched->existing);
    EXPECT_EQ(launched->ball.number, 7U);
    EXPECT_EQ(launched->ball.position, lying.position);
    EXPECT_NEAR(length(launched->ball.velocity - Vec2{0, 3}), 0, 1e-15);
    EXPECT_EQ(launched->ball.spin, 3);
    EXPECT_FALSE(launched->ball.asleep);
}

TEST(Table, PlungerDoesNotFireABallThatIsOnItsWay) {
    Table t = table(true);
    t.apply(control::Launch{1, 2, 1});
    std::vector<Ball> balls = {t.launch({})->ball};
    EXPECT_FALSE(t.launch(balls));
    EXPECT_TRUE(t.launch_waiting());
}

TEST(Table, WithoutLauncherNothingIsQueued) {
    Scene scene = scene_with_everything();
    scene.launcher.reset();
    Table t(std::make_shared<const Scene>(std::move(scene)));
    t.apply(control::Launch{});
    EXPECT_FALSE(t.launch_waiting());
}

TEST(Table, SaveAndRestoreCarryEverything) {
    Table t = table();
    t.apply(control::Flip{Side::left, true});
    t.apply(control::Rotate{true});
    t.apply(control::Launch{0.5, 3, 1});
    t.advance(0.01);
    t.set_open(gate, true);
    t.set_down(drop_1, true);
    EXPECT_EQ(t.numbered({}).number, 1U);
    const State state = t.save(t.scene().balls);
    EXPECT_EQ(state.balls, t.scene().balls);
    Table other = table();
    other.restore(state);
    EXPECT_EQ(other.time(), 0.01);
    EXPECT_EQ(other.rate(bat), 20);
    EXPECT_EQ(other.rate(fan), 3);
    EXPECT_TRUE(other.launch_waiting());
    EXPECT_TRUE(other.parts()[gate].open && other.parts()[drop_1].down);
    EXPECT_EQ(other.numbered({}).number, 2U);
    EXPECT_EQ(other.save({}).parts, t.save({}).parts);
}

TEST(Table, RefusesABallForWhichNoNumberIsLeft) {
    Table t = table();
    State state = t.save(t.scene().balls);
    state.next_number = 4'294'967'294;
    t.restore(state);
    EXPECT_EQ(t.numbered({}).number, 4'294'967'294);
    EXPECT_THROW(static_cast<void>(t.numbered({})), Refusal);
    EXPECT_THROW(static_cast<void>(t.numbered({})), Refusal);
}

TEST(Table, KnowsWhomAGateBlocks) {
    Table t = table();
    t.set_blocked(gate, 7, true);
    t.set_blocked(gate, 0, true);
    t.set_blocked(gate, 0, true);
    EXPECT_EQ(t.blocked(), (std::vector<Blocked>{{gate, 0}, {gate, 7}}));
    EXPECT_TRUE(t.is_blocked(gate, 7));
    EXPECT_FALSE(t.is_blocked(fan, 7));
    // Of balls that are there, and of closed gates.
    EXPECT_EQ(t.save(t.scene().balls).blocked, (std::vector<Blocked>{{gate, 0}}));
    t.set_blocked(gate, 7, false);
    EXPECT_FALSE(t.is_blocked(gate, 7));
    t.set_open(gate, true);
    EXPECT_TRUE(t.save(t.scene().balls).blocked.empty());
}

}  // namespace
}  // namespace flipside

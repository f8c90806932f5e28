#include <algorithm>
#include <set>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "custom/between.hpp"
#include "custom/continuous/neighbours.hpp"

namespace flipside::custom::test {
namespace {

Ball ball_at(Vec2 position, double radius) {
    Ball ball;
    ball.position = position;
    ball.radius = radius;
    return ball;
}

std::vector<Ball> some_balls() {
    std::vector<Ball> balls;
    const int count = *rc::gen::inRange(1, 60);
    const double ratio = *rc::gen::element(1.0, 3.0, 300.0);
    for (int i = 0; i < count; ++i)
        balls.push_back(ball_at({between(-1, 1), between(-1, 1)}, 0.02 * std::pow(ratio, between(0, 1))));
    return balls;
}

std::set<BallIndex> near(const Cells& cells, BallIndex i) {
    std::set<BallIndex> found;
    cells.query_neighbours(i, [&](BallIndex j) { found.insert(j); });
    return found;
}

bool touch(const Ball& a, const Ball& b) {
    return length(a.position - b.position) <= a.radius + b.radius;
}

// For any motion within time_in_cell(), queries from either ball find both balls of each touching pair.
RC_GTEST_PROP(Cells, FindTouchingBallsUntilOneLeavesItsCell, ()) {
    std::vector<Ball> balls = some_balls();
    Cells cells;
    cells.reset(balls);
    for (BallIndex i = 0; i < balls.size(); ++i) {
        const double width = Cells::width_for(balls[i].radius) * *rc::gen::element(1.0, 1.0, 5.0);
        cells.insert(i, cells.level_for(width), balls[i].position);
    }
    for (BallIndex i = 0; i < balls.size(); ++i) {
        const Vec2 velocity{between(-3, 3), between(-3, 3)}, top{between(0, 9), between(0, 9)};
        const double stays = cells.time_in_cell(i, balls[i].position, velocity, top);
        RC_ASSERT(stays > 0);
        const double t = between(0, 1) * std::min(stays, 10.0);
        const Vec2 bend{between(-1, 1) * top.x, between(-1, 1) * top.y};
        balls[i].position += t * velocity + 0.5 * t * t * bend;
    }
    for (BallIndex i = 0; i < balls.size(); ++i)
        for (BallIndex j = 0; j < balls.size(); ++j)
            if (i != j && touch(balls[i], balls[j])) RC_ASSERT(near(cells, i).contains(j));
}

TEST(Cells, ALevelIsTheFirstWhoseCellsAreWideEnough) {
    Ball smallest;
    smallest.radius = 0.1;
    Cells cells;
    cells.reset({&smallest, 1});
    double width = Cells::width_for(smallest.radius);
    EXPECT_EQ(cells.level_for(width / 2), 0U);
    for (const std::uint32_t level : {0U, 1U, 2U, 3U, 4U}) {
        EXPECT_EQ(cells.level_for(width), level);
        EXPECT_EQ(cells.level_for(std::nextafter(width, INFINITY)), level + 1);
        width *= 2;
    }
    EXPECT_EQ(cells.level_for(1e300), cells.level_for(1e200)) << "the last level";
}

// After a ball has changed its cell, query_new_neighbours() returns what the query from the old cell did not.
RC_GTEST_PROP(Cells, OldAndNewNeighboursAreAllNeighbours, ()) {
    const std::vector<Ball> balls = some_balls();
    Cells cells;
    cells.reset(balls);
    for (BallIndex i = 0; i < balls.size(); ++i)
        cells.insert(i, cells.level_for(Cells::width_for(balls[i].radius)), balls[i].position);
    std::set<BallIndex> seen = near(cells, 0);
    const Cells::Cell before = cells[0];
    cells.insert(0, before.level, {between(-1, 1), between(-1, 1)});
    cells.query_new_neighbours(0, before, [&](BallIndex j) { seen.insert(j); });
    RC_ASSERT(std::ranges::includes(seen, near(cells, 0)));
}

TEST(Cells, DoNotFindARemovedBall) {
    const std::vector<Ball> balls{ball_at({0, 0}, 0.1), ball_at({0.1, 0}, 0.1), ball_at({0, 0.1}, 1)};
    Cells cells;
    cells.reset(balls);
    for (BallIndex i = 0; i < 3; ++i)
        cells.insert(i, cells.level_for(Cells::width_for(balls[i].radius)), balls[i].position);
    EXPECT_EQ(near(cells, 0), (std::set<BallIndex>{1, 2}));
    cells.remove(1);
    EXPECT_EQ(near(cells, 0), (std::set<BallIndex>{2}));
    cells.remove(1);
    cells.insert(1, cells[1].level, {0.1, 0});
    EXPECT_EQ(near(cells, 2), (std::set<BallIndex>{0, 1}));
}

}  // namespace
}  // namespace flipside::custom::test

// Heaps come to rest where they should, and only there, and gain no energy from overlap.

#include <random>

#include <gtest/gtest.h>

#include "custom/scenes.hpp"
#include "custom/tolerances.hpp"

namespace flipside::custom::test {
namespace {

constexpr double g = 9.81;

double energy(const World& world) {
    double sum = 0;
    for (const Ball& ball : world.balls())
        sum += ball.mass * (0.5 * length_squared(ball.velocity) + g * ball.position.y) +
               0.5 * inertia(ball) * ball.spin * ball.spin;
    return sum;
}

/// Two balls on a floor and one on top, all of radius 0.1 m.
Scene pyramid(double friction) {
    Scene scene = empty_scene({0, -g});
    scene.materials[0].friction = friction;
    add_ball(scene, {-0.1, 0.1});
    add_ball(scene, {0.1, 0.1});
    add_ball(scene, {0, 0.1 + 0.2 * std::sqrt(0.75)});
    add_part(scene, segment({-9, 0}, {9, 0}), {"", 0.5, friction, 0});
    return scene;
}

TEST(Piles, FrictionlessPyramidFollowsItsEnergy) {
    // Line of centres at θ from the vertical, 30° at first: with x = 2r·sin θ and y = 2r·cos θ,
    // θ'²·(2cos²θ + sin²θ) = (g/r)·(cos θ₀ − cos θ) for as long as the balls touch.
    const auto world = make_world(pyramid(0));
    run(*world, 0.15);
    const std::span<const Ball> balls = world->balls();
    const double cosine = (balls[2].position.y - balls[1].position.y) / 0.2;
    const double turn = std::sqrt(g / 0.1 * (std::sqrt(0.75) - cosine) / (1 + cosine * cosine));
    EXPECT_LT(cosine, 0.85);
    // They creep for the first long tick (1/60 s), which takes them up to a hundredth of a radius ahead of
    // the exact positions.
    EXPECT_NEAR(balls[1].velocity.x, 0.2 * cosine * turn, 0.08 * 0.2 * cosine * turn);
    EXPECT_NEAR(balls[0].velocity.x, -balls[1].velocity.x, 0.01 * balls[1].velocity.x);
    run(*world, 0.85);
    EXPECT_LT(world->balls()[0].position.x, -0.2);
    EXPECT_GT(world->balls()[1].position.x, 0.2);
}

TEST(Piles, RoughPyramidStandsFromFrictionOfTan15Degrees) {
    for (const double friction : {0.2, 0.3}) {
        const auto world = make_world(pyramid(friction));
        run(*world, 1);
        const double aside = world->balls()[1].position.x - 0.1;
        if (friction < 2 - std::sqrt(3)) {
            EXPECT_GT(aside, 0.1);
        } else {
            EXPECT_LT(aside, 1e-4);
            EXPECT_EQ(world->statistics().asleep, 3U);
        }
    }
}

/// Balls of 50 to 100 mm in loose rows above a pit with vertical walls, flat or of two slopes.
Scene pit(int balls, bool slopes, double friction, double restitution) {
    Scene scene = empty_scene({0, -g});
    scene.rest_speed = 0.1;
    scene.materials[0] = {"ball", std::sqrt(restitution), friction, 0};
    const double deep = slopes ? 1.5 : 0;
    add_part(scene, {shape::Polyline{{{-1.5, 90}, {-1.5, deep}, {0, 0}, {1.5, deep}, {1.5, 90}}, false}},
             {"", std::sqrt(restitution), friction, 0});
    for (int i = 0; i < balls; ++i) {
        const double radius = 0.05 + 0.05 * (i * 7 % 11) / 10;
        add_ball(scene, {-1.38 + 0.21 * (i % 14) + 0.001 * (i % 7), deep + 0.3 + 0.205 * (i / 14)}, {},
                 radius, 100 * radius * radius);
    }
    return scene;
}

/// Of the two balls in a contact, or of the ball on a part, m.
double smaller_radius(const Contact& contact, std::span<const Ball> balls) {
    const double radius = find_ball(balls, contact.ball)->radius;
    return contact.other.is_ball ? std::min(radius, find_ball(balls, contact.other.index)->radius) : radius;
}

/// Runs until all balls sleep, and longer. A step may add the energy that lifts all balls out of the deepest
/// overlap, all steps together a hundredth of the energy that is lost. At the end nothing moves, and no
/// overlap would keep a ball awake.
void expect_rest(World& world, double seconds) {
    double weight = 0;
    for (const Ball& ball : world.balls()) weight += ball.mass * g;
    constexpr double slack = 1e-3 * 0.05;  // m: distance up to which balls count as touching
    const double first = energy(world);
    double before = first, gained = 0;
    while (world.time() < seconds && world.statistics().asleep < world.balls().size()) {
        const double overlap = deepest_overlap(world.contacts());
        world.step(1.0 / 60);
        const double gain = energy(world) - before;
        EXPECT_LE(gain, weight * (overlap + slack) + 1e-9 * first) << "at " << world.time() << " s";
        gained += std::max(0.0, gain);
        before += gain;
    }
    EXPECT_EQ(world.statistics().asleep, world.balls().size()) << "at " << world.time() << " s";
    EXPECT_LT(gained, 0.01 * (first - before));
    const std::vector<Ball> rest(world.balls().begin(), world.balls().end());
    run(world, 0.5);
    for (std::size_t i = 0; i < rest.size(); ++i) {
        EXPECT_EQ(world.balls()[i], rest[i]);
        EXPECT_EQ(rest[i].velocity, Vec2{});
    }
    for (const Contact& contact : world.contacts())
        EXPECT_LE(-contact.separation, squeezed_overlap * smaller_radius(contact, rest));
}

TEST(Piles, HeapsOfMixedSizesFallAsleep) {
    for (const double friction : {0.0, 0.5})
        for (const double restitution : {0.0, 0.5, 0.8}) {
            SCOPED_TRACE(testing::Message() << "friction " << friction << " restitution " << restitution);
            expect_rest(*make_world(pit(120, false, friction, restitution)), 20);
        }
}

/// Balls of 20 to 40 mm that fall in a box, from rows with random speeds of up to 1.4 m/s.
Scene falling_rows(int balls, unsigned seed) {
    std::mt19937 random(seed);
    const auto between = [&](double from, double to) {
        return from + (to - from) * static_cast<double>(random()) / 0x1p32;
    };
    Scene scene = empty_scene({0, -g});
    scene.rest_speed = 0;
    scene.materials[0] = {"ball", 0, 0, 0};
    add_part(scene, {shape::Polyline{{{-0.5, 9}, {-0.5, 0}, {0.5, 0}, {0.5, 9}}, false}}, {"", 0, 0, 0});
    for (int i = 0; i < balls; ++i) {
        const double radius = between(0.02, 0.04);
        add_ball(scene, {-0.44 + 0.125 * (i % 8), 0.1 + 0.125 * (i / 8)}, {between(-1, 1), between(-1, 1)},
                 radius, 1000 * radius * radius);
    }
    return scene;
}

// Nothing bounces, and no impact is too slow to be one: balls that fall on a heap have impacts without end
// and are held, many at a time, for less than a tick.
TEST(Piles, BallsWithoutBounceOverlapLittleWhileTheyFall) {
    for (const unsigned seed : {1U, 2U, 3U}) {
        const auto world = make_world(falling_rows(200, seed));
        double deepest = 0;
        while (world->time() < 1.5) {
            world->step(1.0 / 240);
            for (const Contact& contact : world->contacts())
                deepest = std::max(deepest, -contact.separation / smaller_radius(contact, world->balls()));
        }
        EXPECT_LT(deepest, 0.04) << "seed " << seed;
    }
}

TEST(Piles, FiftyInAVFallAsleep) {
    for (const double friction : {0.0, 0.5}) {
        SCOPED_TRACE(testing::Message() << "friction " << friction);
        expect_rest(*make_world(pit(50, true, friction, 0.5)), 20);
    }
}

TEST(Piles, HundredsFallAsleep) {
    expect_rest(*make_world(pit(320, false, 0.3, 0.5)), 30);
}

/// Loose rows of balls above a pit that is a part of a ball too narrow for so many in a row.
Scene narrow_pit(int balls, double missing, int rows) {
    constexpr double r = 0.1;
    const double width = (balls - missing) * 2 * r;
    Scene scene = empty_scene({0, -g});
    scene.rest_speed = 0.1;
    scene.materials[0] = {"ball", 0.7, 0, 0};
    add_part(scene, {shape::Polyline{{{0, 90}, {0, 0}, {width, 0}, {width, 90}}, false}}, {"", 0.7, 0, 0});
    for (int row = 0; row < rows; ++row)
        for (int i = 0; i < static_cast<int>((width - 2 * r) / 0.21); ++i)
            add_ball(scene, {r + 0.005 + 0.21 * i + 0.004 * (row % 3),
                             0.3 + 0.25 * row + 0.01 * ((7 * i + 3 * row) % 5)});
    return scene;
}

// The rows above press one ball too many into the lowest.
TEST(Piles, ARowWithoutRoomForOneOfItsBallsFallsAsleep) {
    expect_rest(*make_world(narrow_pit(60, 0.1, 6)), 30);
    expect_rest(*make_world(narrow_pit(72, 0.15, 6)), 30);
    expect_rest(*make_world(narrow_pit(85, 0.2, 8)), 30);
}

TEST(Piles, ColumnsStand) {
    for (const int balls : {10, 50}) {
        Scene scene = empty_scene({0, -g});
        scene.rest_speed = 0.1;
        for (int i = 0; i < balls; ++i) add_ball(scene, {0, 0.1 + 0.2 * i});
        add_part(scene, segment({-1, 0}, {1, 0}), {"", 0.5, 0, 0});
        const auto world = make_world(scene);
        run(*world, 1);
        EXPECT_EQ(world->statistics().asleep, static_cast<std::uint64_t>(balls));
        for (int i = 0; i < balls; ++i) {
            const Vec2 p = world->balls()[static_cast<std::size_t>(i)].position;
            EXPECT_EQ(p.x, 0);
            EXPECT_NEAR(p.y, 0.1 + 0.2 * i, 1e-6) << "ball " << i;
        }
    }
}

TEST(Piles, ASavedHeapContinuesWithTheSameBits) {
    const Scene scene = pit(60, true, 0.5, 0.5);
    const auto through = make_world(scene), other = make_world(scene);
    run(*through, 1);
    const State state = through->save();
    EXPECT_FALSE(state.memory.forces.empty());
    other->restore(state);
    run(*through, 0.5);
    run(*other, 0.5);
    for (std::size_t i = 0; i < scene.balls.size(); ++i) EXPECT_EQ(through->balls()[i], other->balls()[i]);
    EXPECT_EQ(through->save().memory, other->save().memory);
}

TEST(Piles, ASleepingBallWithoutItsSupportFalls) {
    // A column of three, of which a fast ball removes the lowest.
    Scene scene = empty_scene({0, -g});
    scene.rest_speed = 0.1;
    for (int i = 0; i < 3; ++i) add_ball(scene, {0, 0.1 + 0.2 * i});
    add_part(scene, segment({-9, 0}, {9, 0}), {"", 0.5, 0, 0});
    const auto world = make_world(scene);
    run(*world, 0.3);
    ASSERT_EQ(world->statistics().asleep, 3U);
    Ball shot = scene.balls[0];
    shot.position = {-0.5, 0.1};
    shot.velocity = {8, 0};
    world->add(shot);
    double lowest = 0.5;
    for (int i = 0; i < 30; ++i) {
        world->step(1.0 / 60);
        lowest = std::min(lowest, world->balls()[2].position.y);
    }
    EXPECT_LT(lowest, 0.45);
}

}  // namespace
}  // namespace flipside::custom::test

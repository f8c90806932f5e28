// The exact engine as a World: many balls, precision and what it claims, refusals, states.

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "places.hpp"
#include "reference/support.hpp"
#include "world/refusal.hpp"
#include "world/scene_file.hpp"

namespace flipside::reference::test {
namespace {

/// Eleven balls of different masses in a box, and a turning bar.
Scene gas() {
    Scene scene = empty_scene({0, -1});
    scene.rest_speed = 0;
    add_part(scene, {shape::Polyline{{{0, 0}, {4, 0}, {4, 3}, {0, 3}}, true}});
    Part& bar = add_part(scene, segment({1.5, 1.5}, {2.5, 1.5}));
    bar.motion = motion::Turn{{2, 1.5}, 1.5, true};
    for (int i = 0; i < 11; ++i)
        add_ball(scene, {0.4 + 0.3 * i, i % 2 == 0 ? 0.4 : 2.5}, {std::sin(3.0 * i), std::cos(5.0 * i)}, 0.1,
                 1 + i % 3);
    return scene;
}

TEST(ReferenceWorld, TheStepChangesNothingButRounding) {
    const auto coarse = make_world(gas()), fine = make_world(gas());
    run(*coarse, 2, 1.0 / 4);
    run(*fine, 2, 1.0 / 256);
    for (std::size_t i = 0; i < coarse->balls().size(); ++i)
        EXPECT_LT(length(coarse->balls()[i].position - fine->balls()[i].position), 1e-10);
}

// Far from the origin a position is rounded to more than a radius is; bounces below that are rest.
TEST(ReferenceWorld, BouncesEndAlsoFarFromTheOrigin) {
    for (const double height : {0.0, 1.0, 100.0, 5000.0})
        for (const double restitution : {0.3, 0.5, 0.9}) {
            SCOPED_TRACE(std::to_string(height) + " m, e = " + std::to_string(restitution));
            Scene scene = empty_scene({0, -9.81});
            scene.bounds = {{-1e4, -1e4}, {1e4, 1e4}};
            scene.rest_speed = 0;
            add_part(scene, segment({-1, height}, {1, height}), {"", restitution, 0, 0});
            add_ball(scene, {0, height + 1}, {}, 0.0135);
            const auto world = make_world(scene);
            std::uint64_t impacts = 0;
            for (int step = 0; step < 600; ++step) {
                ASSERT_NO_THROW(world->step(1.0 / 60));
                impacts += world->statistics().impacts;
            }
            // Each is e times as fast as the one before, from 4.4 m/s down to what rounding leaves.
            EXPECT_LT(static_cast<double>(impacts), 5 + std::log(1e-9) / std::log(restitution)) << height;
            EXPECT_NEAR(world->balls()[0].position.y, height + 0.0135, 1e-9) << height;
        }
}

// There an impact is searched for and found late by some rounding, in which the ball gains speed.
TEST(ReferenceWorld, BouncesEndAlsoOnATurningPartAndWithDrag) {
    for (const double damping : {0.0, 0.05})
        for (const double rate : {0.0, -0.05})
            for (const double restitution : {0.3, 0.5, 0.8}) {
                SCOPED_TRACE(std::to_string(damping) + "/s, " + std::to_string(rate) +
                             " rad/s, e = " + std::to_string(restitution));
                Scene scene = empty_scene({0, -9.81});
                scene.rest_speed = 0;
                scene.damping = damping;
                Part& floor = add_part(scene, segment({-8, 0}, {8, -0.5}), {"", restitution, 0.3, 0});
                if (rate != 0) floor.motion = motion::Turn{{0.1, 0.2}, rate, true};
                add_ball(scene, {3, 0.5}, {}, 0.03);
                const auto world = make_world(scene);
                std::uint64_t impacts = 0;
                for (int step = 0; step < 240; ++step) {
                    ASSERT_NO_THROW(world->step(1.0 / 60));
                    impacts += world->statistics().impacts;
                }
                EXPECT_LT(static_cast<double>(impacts), 5 + std::log(1e-9) / std::log(restitution));
            }
}

TEST(ReferenceWorld, AStepInPortionsIsTheSameStepAndShowsNothingBeforeItsEnd) {
    const auto whole = make_world(gas(), {{"twin", "on"}}), portions = make_world(gas(), {{"twin", "on"}});
    int calls = 0;
    for (int step = 0; step < 4; ++step) {
        whole->step(1.0 / 2);
        const Vec2 shown = portions->balls()[0].position;
        for (; !portions->step_within(1.0 / 2, 0); ++calls) {
            EXPECT_EQ(portions->time(), step / 2.0);
            EXPECT_EQ(portions->balls()[0].position, shown);
        }
        ASSERT_EQ(whole->time(), portions->time());
        ASSERT_EQ(whole->events().size(), portions->events().size());
        for (std::size_t i = 0; i < whole->balls().size(); ++i) {
            EXPECT_EQ(whole->balls()[i].position, portions->balls()[i].position);
            EXPECT_EQ(whole->uncertainty()[i], portions->uncertainty()[i]);
        }
    }
    EXPECT_GT(calls, 10);
}

TEST(ReferenceWorld, AStepUnderWayCanBeGivenUp) {
    const auto given_up = make_world(gas()), fresh = make_world(gas());
    const State start = given_up->save();
    ASSERT_FALSE(given_up->step_within(2, 0));
    given_up->restore(start);
    run(*given_up, 1);
    run(*fresh, 1);
    for (std::size_t i = 0; i < fresh->balls().size(); ++i)
        EXPECT_EQ(given_up->balls()[i].position, fresh->balls()[i].position);
}

TEST(ReferenceWorld, ElasticBallsKeepTheirEnergyAmongStillWalls) {
    Scene scene = gas();
    scene.parts.pop_back();
    const auto world = make_world(scene);
    const auto energy = [&] {
        double sum = 0;
        for (const Ball& ball : world->balls())
            sum += ball.mass * (length_squared(ball.velocity) / 2 + ball.position.y);
        return sum;
    };
    const double before = energy();
    run(*world, 20);
    EXPECT_NEAR(energy(), before, 1e-12 * before);
}

TEST(ReferenceWorld, ClaimsOnlyTheDigitsThatHold) {
    const auto claimed = make_world(gas(), {{"twin", "on"}}),
               truth = make_world(gas(), {{"precision", "113"}});
    EXPECT_EQ(claimed->uncertainty().size(), claimed->balls().size());
    bool some = false;
    for (int i = 0; i < 40; ++i) {
        claimed->step(1.0 / 10);
        truth->step(1.0 / 10);
        for (std::size_t k = 0; k < claimed->balls().size(); ++k) {
            const double error = length(claimed->balls()[k].position - truth->balls()[k].position);
            EXPECT_LE(error, claimed->uncertainty()[k] + 1e-15);
            some = some || claimed->uncertainty()[k] < 1e-12;
        }
    }
    EXPECT_TRUE(some);
    EXPECT_TRUE(make_world(gas())->uncertainty().empty());
}

/// A ball that goes to and fro at 10 m/s between walls with this much room, m, for one step of 1/60 s.
std::string rattled_in(double room, const char* precision, double drag = 0) {
    Scene scene = empty_scene();
    scene.damping = drag;
    add_ball(scene, {0, 0}, {0, 10});
    for (const double y : {-0.1, 0.1 + room}) add_part(scene, segment({-1, y}, {1, y}));
    const auto world = make_world(scene, {{"precision", precision}, {"twin", "off"}});
    try {
        world->step(1.0 / 60);
    } catch (const Refusal& refusal) {
        const std::string why = refusal.what();
        return why.substr(0, why.find(" at "));
    }
    const double way = drag > 0 ? 10 * -std::expm1(-drag / 60) / drag : 10.0 / 60;
    EXPECT_EQ(world->statistics().impacts, std::floor(way / room));
    return "";
}

TEST(ReferenceWorld, AStepWithTooManySearchesIsRefused) {
    EXPECT_EQ(rattled_in(1e-5, "53"), "");   // 16,666 impacts
    EXPECT_EQ(rattled_in(1e-4, "113"), "");  // 1,666
    const std::string why = "reference: ball 0 hits part 0 after too many searches in one step";
    EXPECT_EQ(rattled_in(1e-8, "53"), why);
    EXPECT_EQ(rattled_in(1e-6, "113"), why);
    // With drag each search takes much longer.
    EXPECT_EQ(rattled_in(1e-5, "53", 1), "");
    EXPECT_EQ(rattled_in(2e-6, "53", 1), why);
    EXPECT_EQ(rattled_in(3e-4, "113", 1), "");
    EXPECT_EQ(rattled_in(3e-5, "113", 1), why);
}

/// Where drag is strong, a search for the border goes by steps that are far too small.
TEST(ReferenceWorld, ASearchForABorderThatDoesNotEndNamesTheBallAndTheBorder) {
    Scene scene = empty_scene();
    scene.damping = 1e6;
    add_ball(scene, {scene.bounds.max.x - 1e-4, 0}, {10, 0});
    const auto world = make_world(scene);
    std::string why;
    try {
        world->step(1.0 / 60);
    } catch (const Refusal& refusal) {
        why = refusal.what();
    }
    EXPECT_EQ(why,
              "reference: ball 0 and the bounds, from 0 s on: the search for their next touch has passed its "
              "bound of steps");
}

TEST(ReferenceWorld, PilesAreRefusedAndTheWorldStaysReadable) {
    Scene scene = empty_scene({0, -9.81});
    scene.materials[0].restitution = 0.5;
    add_part(scene, segment({-1, 0}, {1, 0}), {"", 0.5, 0, 0});
    add_ball(scene, {0, 0.1});
    add_ball(scene, {0, 0.4});
    add_ball(scene, {0, 2.6});  // when the others are at rest
    const auto world = make_world(scene);
    std::string why;
    for (int i = 0; i < 600 && why.empty(); ++i) {
        const double before = world->time();
        try {
            world->step(1.0 / 60);
        } catch (const Refusal& refusal) {
            why = refusal.what();
            EXPECT_EQ(world->time(), before);
        }
    }
    EXPECT_NE(why.find("ball"), std::string::npos) << why;
    EXPECT_NE(why.find(" s"), std::string::npos) << why;
    EXPECT_THROW(world->step(1.0 / 60), Refusal);
    State state = world->save();
    EXPECT_EQ(state.balls.size(), 3U);
    state.balls.pop_back();
    world->restore(state);
    EXPECT_NO_THROW(run(*world, 1));
}

TEST(ReferenceWorld, GoesOnFromAState) {
    const auto whole = make_world(gas()), begun = make_world(gas()), rest = make_world(gas());
    run(*whole, 2);
    run(*begun, 1);
    rest->restore(begun->save());
    run(*rest, 1);
    EXPECT_EQ(rest->time(), whole->time());
    for (std::size_t i = 0; i < whole->balls().size(); ++i)
        EXPECT_LT(length(whole->balls()[i].position - rest->balls()[i].position), 1e-9);
}

// The joints of a turned floor lie in line but for rounding, and rounding may have a ball over both
// primitives.
TEST(ReferenceWorld, SlidesOverTheJointsOfATurnedFloor) {
    constexpr double speed = 5, radius = 0.1;
    for (const double angle : {0.3, 0.7, 1.1}) {
        const Vec2 along = from_angle(angle);
        Scene scene = empty_scene(-9.81 * perp(along));
        scene.bounds = {{-100, -100}, {100, 100}};
        shape::Polyline floor;
        for (int i = 0; i <= 2000; ++i) floor.points.push_back((20 + 0.01 * i) * along);
        add_part(scene, {floor});
        add_ball(scene, 21 * along + radius * perp(along), speed * along, radius);
        const auto world = make_world(scene);
        run(*world, 3.5, 1.0 / 60);
        EXPECT_NEAR(dot(world->balls()[0].position, along), 21 + speed * 3.5, 1e-9);
        EXPECT_NEAR(dot(world->balls()[0].position, perp(along)), radius, 1e-12);
    }
}

TEST(ReferenceWorld, TheSameRunGivesTheSameBits) {
    const auto one = make_world(gas()), other = make_world(gas());
    run(*one, 3);
    run(*other, 3);
    EXPECT_TRUE(std::ranges::equal(one->balls(), other->balls()));
}

TEST(ReferenceWorld, PinballAgreesWithAHundredBitsForTheDigitsItClaims) {
    const Scene scene = load_scene(flipside::test::source("assets/scenes/pinball.json"));
    const auto claimed = make_world(scene, {{"twin", "on"}}),
               truth = make_world(scene, {{"precision", "113"}});
    for (World* world : {claimed.get(), truth.get()}) world->apply(control::Launch{0.8, 1, 1});
    double worst = 0;
    for (int i = 0; i < 150; ++i) {
        claimed->step(1.0 / 60);
        truth->step(1.0 / 60);
        ASSERT_EQ(claimed->balls().size(), 1U);
        const double error = length(claimed->balls()[0].position - truth->balls()[0].position);
        worst = std::max(worst, claimed->uncertainty()[0]);
        ASSERT_LE(error, claimed->uncertainty()[0] + 1e-16);
    }
    std::printf("pinball, 2.5 s: uncertainty at most %.2g m\n", worst);
    EXPECT_LT(worst, 1e-5);
}

}  // namespace
}  // namespace flipside::reference::test

#include "lab/hunt/hunt.hpp"

#include <cmath>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>
#include <unistd.h>

#include "lab/contenders/engines.hpp"
#include "lab/files/data_file.hpp"
#include "lab/hunt/hard.hpp"
#include "lab/hunt/mutate.hpp"
#include "world/input_error.hpp"
#include "world/scene_file.hpp"
#include "world/scene_json.hpp"

namespace flipside::lab::hunt {
namespace {

namespace fs = std::filesystem;

ContenderRequest contender(const std::string& text) {
    const std::string texts[] = {text};
    return parse_contenders(texts).front();
}

Request request_for(Goal goal, const std::string& text) {
    return {.contender = contender(text), .goal = goal, .seconds = 0.5, .scenes = 60, .rounds = 3};
}

class Hunt : public ::testing::Test {
  protected:
    fs::path folder = fs::temp_directory_path() / ("flipside-hunt-" + std::to_string(getpid()));
    std::vector<std::string> said;

    void TearDown() override { fs::remove_all(folder); }
    auto hunt_in(const std::string& name, const Request& request, sweep::Shard shard = {}) {
        return hunt(
            request, shard, folder / name, [](double) {}, [&](const std::string& s) { said.push_back(s); });
    }
    [[nodiscard]] std::string text(const std::string& name) const {
        std::ostringstream all;
        all << std::ifstream(folder / name).rdbuf();
        return all.str();
    }
};

TEST_F(Hunt, InPartsGivesTheSameBytesAsInOne) {
    const Request request = request_for(Goal::overlap, "a=box2d");
    const auto whole = hunt_in("whole", request);
    ASSERT_TRUE(whole);
    EXPECT_EQ(whole->size(), 3U);
    EXPECT_FALSE(hunt_in("parts", request, {2, 2}));
    EXPECT_FALSE(fs::exists(folder / "parts/worst.json"));
    const auto parts = hunt_in("parts", request, {1, 2});
    ASSERT_TRUE(parts);
    for (const char* file : {"worst.json", "rounds.csv", "plan.txt", "rounds/001.txt", "rounds/003.txt"})
        EXPECT_EQ(text(std::string("whole/") + file), text(std::string("parts/") + file)) << file;
    EXPECT_TRUE(said.empty());
}

TEST_F(Hunt, GoesOnForMoreRoundsWhereItEnded) {
    Request request = request_for(Goal::overlap, "a=box2d");
    static_cast<void>(hunt_in("whole", request));
    request.rounds = 2;
    ASSERT_EQ(hunt_in("later", request)->size(), 2U);
    const auto first_written = fs::last_write_time(folder / "later/rounds/001.txt");
    request.rounds = 3;
    ASSERT_EQ(hunt_in("later", request)->size(), 3U);
    for (const char* file : {"worst.json", "rounds.csv", "plan.txt", "rounds/002.txt", "rounds/003.txt"})
        EXPECT_EQ(text(std::string("whole/") + file), text(std::string("later/") + file)) << file;
    EXPECT_EQ(fs::last_write_time(folder / "later/rounds/001.txt"), first_written);
}

TEST_F(Hunt, MakesWhatIsDamagedAgainAndNothingElse) {
    const Request request = request_for(Goal::energy, "a=box2d");
    static_cast<void>(hunt_in("one", request));
    const std::string second = text("one/rounds/002.txt");
    const auto first_written = fs::last_write_time(folder / "one/rounds/001.txt");
    std::ofstream(folder / "one/rounds/002.txt") << second.substr(0, second.size() / 2);
    static_cast<void>(hunt_in("one", request));
    EXPECT_EQ(text("one/rounds/002.txt"), second);
    EXPECT_EQ(fs::last_write_time(folder / "one/rounds/001.txt"), first_written);
    ASSERT_FALSE(said.empty());
    EXPECT_NE(said.front().find("002.txt"), std::string::npos);
    Request other = request;
    other.seed = 2;
    EXPECT_THROW(static_cast<void>(hunt_in("one", other)), InputError);
}

TEST_F(Hunt, WhatIsFoundShowsItselfAgainFromItsFile) {
    for (const Goal goal : {Goal::overlap, Goal::energy, Goal::work}) {
        const Request request = request_for(goal, "a=custom,solver=simple");
        const auto found = hunt_in(std::string(name_of(goal)), request);
        ASSERT_TRUE(found);
        for (std::size_t i = 1; i < found->size(); ++i)
            EXPECT_GE((*found)[i - 1].measured.value, (*found)[i].measured.value);
        const Scene scene = load_scene(folder / name_of(goal) / "worst.json");
        EXPECT_EQ(measure(request, scene).value, found->front().measured.value) << name_of(goal);
        EXPECT_NE(scene.about.find("--replay"), std::string::npos);
    }
}

/// A ball in free fall; by symplectic Euler it is ½·g·dt·t too low.
Scene falling() {
    Scene scene = empty_scene({0, -9.81});
    add_ball(scene, {0, 0}, {0, 0}, 0.1);
    return scene;
}

TEST(Goals, ErrorIsTheDistanceToTheReference) {
    Request request = request_for(Goal::error, "a=box2d");
    const Measured measured = measure(request, falling());
    EXPECT_NEAR(measured.value, 0.5 * 9.81 / 60 * 0.5 / 0.1, 1e-4);
    EXPECT_NEAR(measured.time, 0.5, 1e-9);
    EXPECT_EQ(measured.what, "ball 0");
    request.contender = contender("a=custom");
    EXPECT_LT(measure(request, falling()).value, 1e-12);
}

TEST(Goals, ErrorEndsWhereCollisionsAmplifyATinyShiftOfOneBall) {
    // Each ball hits the next off centre, which amplifies how far the two are apart from where they should
    // be. Nothing else is there, so a shift of all balls alike changes no collision.
    Scene scene = empty_scene();
    const double places[][2] = {
        {0, 0}, {0.3382, 0.0118}, {0.6648, 0.1003}, {1.003, 0.1122}, {1.3297, 0.2006}};
    for (const auto& [x, y] : places) add_ball(scene, {x, y}, {x > 0 ? 0.0 : 20, 0}, 0.02, 1);
    Request request = request_for(Goal::error, "a=custom");
    request.seconds = 1;
    EXPECT_LT(measure(request, scene).value, 2e-11);
}

TEST(Goals, ErrorOfABallThatTheEngineLosesFirstIsHowFarItIsFromTheBounds) {
    // After a third of a second it has fallen by 0.545 m, and by 0.57225 m in Box2D.
    Scene scene = falling();
    scene.bounds = {{-1, -0.572}, {1, 1}};
    const Measured measured = measure(request_for(Goal::error, "a=box2d"), scene);
    EXPECT_NEAR(measured.value, (0.572 - 0.545) / 0.1, 1e-9);
    EXPECT_NEAR(measured.time, 1.0 / 3, 1e-9);
    EXPECT_EQ(measured.what, "ball 0");
}

TEST(Goals, ErrorOfABallThatTheReferenceLosesFirstIsHowFarItIsFromTheBounds) {
    // After a sixth of a second it has risen by 0.36375 m, and by 0.350125 m in Box2D.
    Scene scene = empty_scene({0, -9.81});
    add_ball(scene, {0, 0}, {0, 3}, 0.1);
    scene.bounds = {{-1, -1}, {1, 0.3635}};
    const Measured measured = measure(request_for(Goal::error, "a=box2d"), scene);
    EXPECT_NEAR(measured.value, (0.3635 - 0.350125) / 0.1, 1e-5);
    EXPECT_NEAR(measured.time, 1.0 / 6, 1e-9);
}

TEST(Goals, OverlapIsOfTheSmallerBall) {
    // Without continuous collision, where the first step ends is known.
    Scene scene = empty_scene();
    add_ball(scene, {0, 0}, {0, 0}, 0.1, 1e9);
    add_ball(scene, {0.145, 0}, {-1.2, 0}, 0.04, 1);
    const Request request{
        .contender = contender("a=custom,solver=simple,motion_iterations=1,collision_iterations=1"),
        .dt = 1.0 / 60,
        .goal = Goal::overlap,
        .seconds = 1.0 / 60};
    const Measured measured = measure(request, scene);
    EXPECT_GE(measured.value, 0);
    EXPECT_LE(measured.value, (0.02 - 0.005) / 0.04 + 1e-9);
}

TEST(Goals, EscapesAreCounted) {
    // The simple solver at long steps lets a fast ball through a wall.
    Scene scene = empty_scene();
    scene.bounds = {{-2, -2}, {2, 2}};
    add_part(scene, segment({1, -1}, {1, 1}), {"", 1, 0, 0});
    add_ball(scene, {0.1, 0.013}, {37, 0}, 0.03);
    const Request simple{.contender = contender("a=custom,solver=simple,motion_iterations=1"),
                         .dt = 1.0 / 15,
                         .goal = Goal::escape,
                         .seconds = 0.2};
    EXPECT_EQ(measure(simple, scene).value, 1);
    EXPECT_EQ(measure(simple, scene).what, "1 of 1 balls");
    Request exact = simple;
    exact.contender = contender("a=custom");
    exact.seconds = 0.06;
    EXPECT_EQ(measure(exact, scene).value, 0);
}

TEST(Goals, ABallThatIsLostIsNoGainOfEnergy) {
    // It falls from the origin through the lower bound at −0.5 m after 0.32 s, and takes its −½mgh along.
    Scene scene = falling();
    scene.bounds = {{-0.5, -0.5}, {0.5, 0.5}};
    EXPECT_LT(measure(request_for(Goal::energy, "a=custom"), scene).value, 1e-12);
    EXPECT_LT(measure(request_for(Goal::energy, "a=box2d"), scene).value, 0.02);
}

TEST(Goals, SayNothingWhereSomethingMovesOrGivesEnergy) {
    Scene scene = falling();
    EXPECT_TRUE(says_something(Goal::energy, scene));
    add_part(scene, segment({1, 0}, {1, 1}), {"", 0.5, 0, 2});
    EXPECT_FALSE(says_something(Goal::energy, scene));
    EXPECT_TRUE(says_something(Goal::escape, scene));
    scene.parts.back().motion = motion::Turn{{0, 0}, 1, true};
    EXPECT_FALSE(says_something(Goal::escape, scene));
    EXPECT_TRUE(says_something(Goal::error, scene));
    EXPECT_EQ(goal_named("lost"), Goal::escape);
    EXPECT_EQ(goal_named("time"), Goal::work);
    try {
        static_cast<void>(goal_named("speed"));
        FAIL() << "there is no such goal";
    } catch (const InputError& error) {
        EXPECT_STREQ(
            error.what(),
            "unknown goal 'speed'; allowed are overlap, energy, escape or lost, error, work or time");
    }
}

/// A hunt finds the same with gcc and clang: no two draws are operands or arguments of one call.
TEST(RandomScenes, AreTheSameFromEveryCompiler) {
    std::string all;
    for (unsigned seed = 0; seed < 200; ++seed) {
        RandomScene random(seed);
        Scene scene = random.make();
        all += to_json(scene);
        for (int change = 0; change < 5; ++change) all += to_json(scene = neighbour_of(scene, random));
    }
    EXPECT_EQ(checksum(all), "f41483b186b6a3d2");
}

TEST(Neighbours, AreScenesWithinTheirLimits) {
    RandomScene random(5);
    Scene scene = random.make();
    int valid = 0;
    for (int i = 0; i < 500; ++i) {
        const auto next = written(neighbour_of(scene, random));
        if (!next) continue;
        ++valid;
        scene = next->scene;
        ASSERT_GE(scene.balls.size(), 1U);
        ASSERT_LE(scene.balls.size(), 6U);
        ASSERT_LE(scene.parts.size(), 6U);
        ASSERT_LE(scene.materials.size(), scene.parts.size() + scene.balls.size() + 1);
        for (const Ball& ball : scene.balls) {
            ASSERT_GE(ball.mass, 0.03);
            ASSERT_LE(ball.mass, 30);
        }
    }
    EXPECT_GT(valid, 200);
}

TEST(Shrinking, KeepsMostOfWhatWasFoundAndDropsTheRest) {
    const Request request = request_for(Goal::error, "a=box2d");
    Scene scene = falling();
    scene.bounds = {{-20, -20}, {20, 20}};
    add_ball(scene, {3.123456789, 1}, {0.1, 0}, 0.1);
    add_part(scene, segment({-9, -9.87654321}, {9, -9}));
    const auto begun = written(scene);
    ASSERT_TRUE(begun);
    const Found found{begun->text, measure(request, begun->scene), 2, 1};
    const Found small = shrunk(request, found, [] {});
    EXPECT_EQ(small.balls, 1U);
    EXPECT_EQ(small.parts, 0U);
    EXPECT_GE(small.measured.value, keep * found.measured.value);
    EXPECT_LT(small.text.size(), found.text.size());
}

TEST(HardScenes, AreAsBadAsWasRecorded) {
    const std::vector<HardScene> all = hard_scenes(hard_folder());
    EXPECT_GE(all.size(), 6U);
    for (const HardScene& hard : all) {
        const Scene scene = load_scene(hard_folder() / hard.scene);
        EXPECT_LE(scene.balls.size(), 6U) << hard.scene;
        EXPECT_LE(scene.parts.size(), 6U) << hard.scene;
        const double now = measure(hard.request, scene).value;
        EXPECT_LE(now, may_grow * hard.recorded) << hard.scene;
        EXPECT_GE(now, 0.9 * hard.recorded) << hard.scene << " was mended: record it anew";
    }
}

}  // namespace
}  // namespace flipside::lab::hunt

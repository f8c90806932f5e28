#include "lab/session/session.hpp"

#include <gtest/gtest.h>

#include "lab/contenders/engines.hpp"
#include "lab/files/assets.hpp"
#include "lab/session/run.hpp"
#include "world/scene_file.hpp"
#include "world/state_file.hpp"

namespace flipside::lab {
namespace {

std::shared_ptr<const Scene> scene_of(const std::string& json) {
    return std::make_shared<const Scene>(parse_scene(json, "test"));
}

/// One ball in free flight from the origin at (1, 2) m/s under `gravity`.
std::shared_ptr<const Scene> flight(const std::string& gravity) {
    return scene_of(R"({"format": "flipside-scene/1", "name": "flight", "about": "A ball in the air.",
        "bounds": {"min": [-100, -100], "max": [100, 100]}, "gravity": )" +
                    gravity + R"(,
        "balls": [{"position": [0, 0], "velocity": [1, 2], "radius": 0.1, "mass": 2}], "parts": []})");
}

Session session_on(std::string_view engine, const std::shared_ptr<const Scene>& scene) {
    return {scene, engine_named(engine), settings_for(engine_named(engine), *scene)};
}

Session pinball_on(std::string_view engine) {
    return session_on(engine, std::make_shared<const Scene>(load_scene(scene_file("pinball"))));
}

TEST(Session, FlightOnTheCustomEngineIsTheParabola) {
    Session session = session_on("custom", flight("[0, -9.81]"));
    const Timeline timeline(0, 1, 1.0 / 60);
    run({&session, 1}, timeline, {}, [](const Session& now, std::uint64_t, double t) {
        const Ball& ball = now.world().balls().front();
        EXPECT_NEAR(ball.position.x, t, 1e-12);
        EXPECT_NEAR(ball.position.y, 2 * t - 0.5 * 9.81 * t * t, 1e-12);
    });
    EXPECT_EQ(session.totals().steps, 60U);
}

/// Where the balls are after so many seconds, in steps of `dt`.
std::vector<Vec2> places_after(double seconds, double dt, const std::shared_ptr<const Scene>& scene,
                               const Script& script) {
    Session session = session_on("custom", scene);
    run({&session, 1}, Timeline(0, seconds, dt), script, [](const Session&, std::uint64_t, double) {});
    std::vector<Vec2> places;
    for (const Ball& ball : session.world().balls()) places.push_back(ball.position);
    return places;
}

constexpr double steps[] = {1.0 / 30, 1.0 / 60, 1.0 / 97, 1.0 / 240, 1.0 / 1000};

TEST(Session, AControlBetweenStepsActsAtItsTimeHoweverLongTheyAre) {
    // Balls that meet often, so that a last digit soon shows. 2 s and all times are short of rounding in
    // binary.
    const auto scene = scene_of(R"({"format": "flipside-scene/1", "name": "box", "about": "Balls in a box.",
        "bounds": {"min": [-2, -2], "max": [2, 2]}, "gravity": [0, 0],
        "balls": [{"position": [0.2, 0.21], "velocity": [3, 2], "radius": 0.2, "mass": 1},
                  {"position": [-0.5, 0.3], "velocity": [-2, 3], "radius": 0.2, "mass": 1},
                  {"position": [-0.31, -0.5], "velocity": [1, -3], "radius": 0.2, "mass": 1}],
        "parts": [{"name": "walls", "shape": {"type": "polyline", "closed": true,
                                              "points": [[-1, -1], [1, -1], [1, 1], [-1, 1]]}}]})");
    const Script script{{0.11, control::Nudge{{0.1, 0.05}}},
                        {0.117, control::Nudge{{-0.3, 0.05}}},
                        {1.04, control::Nudge{{0.1, 0.2}}}};
    const auto once = places_after(20, 1.0 / 240, scene, script);
    ASSERT_EQ(once.size(), 3U);
    for (const double dt : steps) EXPECT_EQ(places_after(20, dt, scene, script), once) << dt;
}

TEST(Session, BallsThatWaitAreLaunchedAtTheSameTimesHoweverLongStepsAre) {
    const auto scene = scene_of(R"({"format": "flipside-scene/1", "name": "lane", "about": "A launcher.",
        "bounds": {"min": [-1, -1], "max": [9, 1]}, "gravity": [0, 0], "balls": [], "parts": [],
        "launcher": {"position": [0, 0], "direction_deg": 0, "speed": [1, 1],
                     "ball": {"radius": 0.1, "mass": 1}}})");
    const Script script{{0.123, control::Launch{1, 3, 1}}, {0.25, control::Launch{1, 2, 0.5}}};
    // The first at once; the others once the one before is a gap of a radius away, 240 looks a second.
    constexpr double at[] = {0.123, 102.0 / 240, 174.0 / 240, 222.0 / 240, 258.0 / 240};
    for (const double dt : steps) {
        const auto places = places_after(2, dt, scene, script);
        ASSERT_EQ(places.size(), std::size(at)) << dt;
        for (std::size_t i = 0; i < std::size(at); ++i)
            EXPECT_NEAR(places[i].x, 2 - at[i], 1e-12) << dt << " s, ball " << i;
    }
}

TEST(Session, AStepInPortionsTakesItsControlsAtTheirTimes) {
    const Script script{{0.25, control::Nudge{{1, 0}}}, {0.5, control::Nudge{{0, 1}}}};
    Session whole = session_on("reference", flight("[0, -9.81]")),
            portions = session_on("reference", flight("[0, -9.81]"));
    std::size_t next = 0, next_portion = 0;
    whole.step(1, script, next);
    EXPECT_FALSE(portions.under_way());
    while (!portions.step_within(1, script, next_portion, 0)) EXPECT_TRUE(portions.under_way());
    EXPECT_FALSE(portions.under_way());
    EXPECT_EQ(next_portion, 2U);
    EXPECT_EQ(portions.totals().steps, 1U);
    EXPECT_EQ(portions.world().time(), 1);
    EXPECT_EQ(portions.world().balls()[0].position, whole.world().balls()[0].position);
    EXPECT_NEAR(portions.world().balls()[0].position.x, 1.75, 1e-12);
}

TEST(Session, AnotherGravityWakesSleepers) {
    const auto table = [](const std::string& gravity) {
        return scene_of(R"({"format": "flipside-scene/1", "name": "table", "about": "A ball on a floor.",
            "bounds": {"min": [-9, -9], "max": [9, 9]}, "gravity": )" +
                        gravity + R"(, "balls": [{"position": [0, 0.1], "radius": 0.1, "mass": 1}],
            "parts": [{"name": "floor", "shape": {"type": "segment", "a": [-5, 0], "b": [5, 0]}}]})");
    };
    Session session = session_on("custom", table("[0, -9.81]"));
    for (int k = 0; k < 60; ++k) session.step(1.0 / 60);
    ASSERT_TRUE(session.world().balls().front().asleep);
    session.change(session.shared_scene(), session.engine(), session.settings());
    EXPECT_TRUE(session.world().balls().front().asleep);
    session.change(table("[0, 9.81]"), session.engine(), session.settings());
    session.step(1.0 / 60);
    EXPECT_NEAR(session.world().balls().front().velocity.y, 9.81 / 60, 1e-12);
}

TEST(Session, ControlsTakeEffectAtTheirOwnTimes) {
    // Without forces the way is the sum of speed times time between the nudges, whatever the step.
    for (const std::string_view engine : {"custom", "box2d"}) {
        Session session = session_on(engine, flight("[0, 0]"));
        const Script script{{0, control::Nudge{{1, 0}}},
                            {0.013, control::Nudge{{2, 0}}},
                            {0.02, control::Nudge{{0, -2}}},
                            {0.1 / 3, control::Nudge{{3, 0}}}};
        std::size_t next = 0;
        for (int k = 0; k < 3; ++k) session.step(0.1 / 6, script, next);
        const Ball& ball = session.world().balls().front();
        const double tolerance = engine == "custom" ? 1e-14 : 1e-6;  // Box2D computes in float
        EXPECT_NEAR(ball.position.x, 2 * 0.05 + 2 * (0.05 - 0.013) + 3 * (0.05 - 0.1 / 3), tolerance);
        EXPECT_NEAR(ball.position.y, 2 * 0.02, tolerance);
        EXPECT_EQ(session.totals().steps, 3U);
        EXPECT_EQ(next, 4U);
        EXPECT_NEAR(session.world().time(), 0.05, 1e-16);
    }
}

TEST(Session, AControlAtTheEndOfAStepBelongsToTheNextOne) {
    Session session = session_on("custom", flight("[0, 0]"));
    const Script script{{0.5 * (1 - 1e-12), control::Nudge{{1, 0}}}};
    std::size_t next = 0;
    session.step(0.5, script, next);
    EXPECT_EQ(next, 0U);
    EXPECT_EQ(session.world().balls().front().velocity.x, 1);
    session.step(0.5, script, next);
    EXPECT_EQ(next, 1U);
    EXPECT_DOUBLE_EQ(session.world().balls().front().position.x, 0.5 + 0.5 * 2);
}

TEST(Session, ARecordingReplaysBitForBit) {
    for (const std::string_view engine : {"custom", "box2d"}) {
        Session played = pinball_on(engine);
        const Script script{{0.0137, control::Launch{0.8}},
                            {1.777, control::Flip{Side::left, true}},
                            {1.9001, control::Flip{Side::left, false}}};
        std::size_t next = 0;
        for (int k = 0; k < 240; ++k) {
            if (k == 100) played.apply(control::Nudge{{0.05, 0.02}});
            if (k == 150) played.apply(control::Flip{Side::right, true});
            played.step(1.0 / 60, script, next);
        }
        ASSERT_EQ(played.recording().controls().size(), 5U);

        Session replayed = pinball_on(engine);
        next = 0;
        const Script recorded = played.recording().controls();
        for (int k = 0; k < 240; ++k) replayed.step(1.0 / 60, recorded, next);
        EXPECT_EQ(to_json(replayed.world().save(), replayed.scene()),
                  to_json(played.world().save(), played.scene()));
        EXPECT_GT(played.totals().impacts, 5U);
        EXPECT_EQ(replayed.totals().impacts, played.totals().impacts);
        EXPECT_EQ(replayed.game().score(), played.game().score());
    }
}

TEST(Session, ChangingTheEngineKeepsEveryBallInItsPlace) {
    Session session = pinball_on("custom");
    session.apply(control::Launch{0.8});
    for (int k = 0; k < 90; ++k) session.step(1.0 / 60);
    const Ball before = session.world().balls().front();
    const Engine& other = engine_named("box2d");
    session.change(session.shared_scene(), other, settings_for(other, session.scene()));
    const Ball after = session.world().balls().front();
    EXPECT_EQ(session.engine().name, "box2d");
    EXPECT_LE(length(after.position - before.position), 1e-6 * before.radius);
    EXPECT_LE(length(after.velocity - before.velocity), 1e-6 * length(before.velocity));
    EXPECT_EQ(session.game().launched(), 1);
}

TEST(Session, RestoringIsNotLaunching) {
    Session first = pinball_on("custom");
    first.apply(control::Launch{1});
    for (int k = 0; k < 30; ++k) first.step(1.0 / 60);
    Session second = pinball_on("custom");
    second.restore(first.world().save());
    second.step(1.0 / 60);
    EXPECT_EQ(second.totals().launched, 0U);
    EXPECT_EQ(second.game().balls_left(), second.scene().rules->balls);
}

TEST(Session, EnergyIsKineticPlusSpinPlusHeight) {
    Scene scene = *flight("[0, -10]");
    scene.balls[0].position = {3, 4};
    scene.balls[0].spin = 5;
    const Session session = session_on("custom", std::make_shared<const Scene>(scene));
    // ½·2·(1+4) + ½·(½·2·0.01)·25 + 2·10·4
    EXPECT_DOUBLE_EQ(energy(session.world(), scene), 5 + 0.125 + 80);
}

TEST(Session, AStrayLeftElsewhereThanThroughTheDrain) {
    Session sideways = session_on("custom", flight("[0, 0]"));  // no rules: whatever is lost is a stray
    for (int k = 0; k < 110; ++k) sideways.step(0.5);
    EXPECT_EQ(sideways.totals().lost, 1U);
    EXPECT_EQ(sideways.totals().strays, 1U);
    EXPECT_EQ(sideways.game().lost(), 1);
}

TEST(NextControl, IsTheFirstNotBeforeTheStart) {
    const Script script{{0, {}}, {1, {}}, {1, {}}, {2, {}}};
    EXPECT_EQ(next_control(script, 0), 0U);
    EXPECT_EQ(next_control(script, 0.5), 1U);
    EXPECT_EQ(next_control(script, 1 + 1e-13), 1U);
    EXPECT_EQ(next_control(script, 1.5), 3U);
    EXPECT_EQ(next_control(script, 3), 4U);
}

TEST(NextControl, ThatARunHasDoneIsNotDoneAgainByTheNext) {
    // Up to a nanosecond before the end of the first run.
    for (const double before : {0.0, 1e-13, 7e-11, 6.7e-10, 9.9e-10, 1.1e-9, 1e-6}) {
        Session session = session_on("custom", flight("[0, 0]"));
        const double dt = 7.0 / 60;
        const Script script{{dt - before, control::Nudge{{0.01, 0}}}};
        const double speed = session.world().balls()[0].velocity.x;
        std::size_t next = 0;
        session.step(dt, script, next);
        next = next_control(script, session.world().time());
        session.step(dt, script, next);
        EXPECT_EQ(next, 1U) << before;
        const double once = session.world().balls()[0].velocity.x - speed;
        Session plain = session_on("custom", flight("[0, 0]"));
        plain.step(dt);
        plain.press(script[0].control);
        plain.step(dt);
        EXPECT_NEAR(once, plain.world().balls()[0].velocity.x - speed, 1e-9) << before;
    }
}

TEST(Overlaps, CountsBallsAtAnotherBallsPlace) {
    std::vector<Ball> balls(5);
    for (Ball& ball : balls) ball.radius = 1;
    balls[1].position = {1e-7, 0};
    balls[2].position = {1e-5, 0};
    balls[3].position = {0, 3};
    balls[4].position = {1e-7, 3};
    EXPECT_EQ(overlaps(balls), 4U);
    EXPECT_EQ(overlaps({}), 0U);
}

}  // namespace
}  // namespace flipside::lab

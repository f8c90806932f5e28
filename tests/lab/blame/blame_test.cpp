#include <numbers>

#include <gtest/gtest.h>

#include "faulty_world.hpp"
#include "lab/blame/blame_run.hpp"
#include "lab/blame/continuation.hpp"
#include "lab/blame/find_blame.hpp"
#include "world/scene_builder.hpp"

namespace flipside::lab {
namespace {

using Does = FaultyWorld::Does;

constexpr double blame_dt = 1.0 / 64;  // s; a power of two, so that steps add up exactly

std::unique_ptr<World> exact_world(const std::shared_ptr<const Scene>& scene) {
    const Engine& engine = engine_named("reference");
    return engine.make(scene, settings_for(engine, *scene));
}

/// What a world is blamed on that makes so many steps of a scene.
Blame blame_of(World& world, const std::shared_ptr<const Scene>& scene, int steps, double dt = blame_dt) {
    const auto exact = exact_world(scene);
    History history;
    history.dt = dt;
    history.end = steps * dt;
    try {
        history.begin(world);
        for (int k = 0; k < steps; ++k) {
            world.step(dt);
            history.add(world, world.events());
        }
    } catch (const Refusal&) {
        // it stopped
    }
    std::vector<KnownEnd> ends;
    go_on(*exact, history.states.front(), history.end, history);
    for (const Ball& ball : exact->balls()) ends.push_back({ball.number, ball.position, ball.radius});
    const double error = worst(world.balls(), ends).radii;
    return find_blame({*scene, history, ends, error, &world}, *exact);
}

Blame blame_of(const Engine& engine, const std::vector<std::string>& changes,
               const std::shared_ptr<const Scene>& scene, int steps, double dt = blame_dt) {
    const Engine* const used = &engine;
    const auto world = engine.make(scene, settings_for(engine, *scene, parse_changes(changes, {&used, 1})));
    return blame_of(*world, scene, steps, dt);
}

/// A ball falls at 2 m/s aslant on the floor "part 0", which it meets at 0.2 s, with e = 0.5.
std::shared_ptr<Scene> aslant_on_floor(double friction = 0) {
    auto scene = std::make_shared<Scene>(empty_scene());
    add_part(*scene, segment({-10, 0}, {10, 0}), {"", 0.5, friction, 0});
    scene->materials[0].friction = friction;
    add_ball(*scene, {0, 0.5}, {1, -2});
    return scene;
}

void expect_at_floor(const Blame& blame) {
    EXPECT_EQ(blame.kind, "segment");
    EXPECT_EQ(blame.other, Other::part(0));
    EXPECT_EQ(blame.ball, 0U);
    EXPECT_NEAR(blame.time, 0.2, 1e-12);
}

TEST(Blame, SemiImplicitEulerDriftsByHalfOfGTimesStepTimesTime) {
    const auto scene = std::make_shared<Scene>(empty_scene({0, -9.81}));
    add_ball(*scene, {0, 0});
    const Blame blame = blame_of(engine_named("box2d"), {}, scene, 31);
    EXPECT_EQ(blame.fault, Fault::drift);
    EXPECT_EQ(stage_of(blame.fault), "integration");
    EXPECT_EQ(blame.kind, "none");
    EXPECT_FALSE(blame.other);
    // It grows evenly, so half of it is passed in step 16 of 31.
    EXPECT_NEAR(blame.time, 16 * blame_dt, 1e-12);
    EXPECT_NEAR(blame.amount, 0.5 * 9.81 * blame_dt * blame.time, 1e-5);
}

TEST(Blame, AContactBetweenTwoStepsIsForContinuousCollision) {
    const auto scene = std::make_shared<Scene>(empty_scene());
    add_part(*scene, segment({50, -10}, {50, 10}));
    scene->parts.back().name = "thin wall";
    add_ball(*scene, {0, 0}, {2000, 0});
    const Blame blame = blame_of(engine_named("custom"), {"solver=simple"}, scene, 2);
    EXPECT_EQ(blame.fault, Fault::tunnelled);
    EXPECT_EQ(stage_of(blame.fault), "continuous collision");
    EXPECT_EQ(blame.kind, "segment");
    EXPECT_EQ(blame.other, Other::part(0));
    EXPECT_NEAR(blame.time, 49.9 / 2000, 1e-12);
    EXPECT_NEAR(blame.amount, 2000, 1e-9);
    EXPECT_NE(in_words(blame, *scene).find("tunnelled at 2000 m/s at segment 'thin wall', ball 0"),
              std::string::npos)
        << in_words(blame, *scene);
}

/// Box2D looks for times of impact between balls only where they are bullets.
TEST(Blame, BallsThatPassThroughEachOtherAreForContinuousCollision) {
    const auto scene = std::make_shared<Scene>(empty_scene());
    add_ball(*scene, {0, 0}, {20, 0});
    add_ball(*scene, {1, 0}, {-20, 0});
    const Blame blame = blame_of(engine_named("box2d"), {"bullets=off"}, scene, 3);
    EXPECT_EQ(blame.fault, Fault::tunnelled);
    EXPECT_EQ(stage_of(blame.fault), "continuous collision");
    EXPECT_EQ(blame.kind, "ball");
    EXPECT_NEAR(blame.time, 0.8 / 40, 1e-12);
}

/// They overlap after the step, but their centres have passed each other: what is found there is too late.
TEST(Blame, BallsThatAreFoundWhenTheyHavePassedAreForContinuousCollision) {
    const auto scene = std::make_shared<Scene>(empty_scene());
    add_ball(*scene, {0, 0}, {16, 0});
    add_ball(*scene, {0.375, 0}, {-16, 0});
    const Blame blame = blame_of(engine_named("box2d"), {"bullets=off"}, scene, 3);
    EXPECT_EQ(blame.fault, Fault::tunnelled);
    EXPECT_NEAR(blame.time, 0.175 / 32, 1e-12);
}

/// Slow enough to be in the floor after the step: it is not the motion that hid the contact.
TEST(Blame, AnOverlapIsForTheNarrowPhaseOrForTheBroadPhaseThatDidNotFindThePair) {
    struct Expected {
        Does does;
        Fault fault;
        std::string_view stage;
    };
    for (const auto& [does, fault, stage] : {Expected{Does::pass, Fault::missed, "narrow phase"},
                                             Expected{Does::overlook, Fault::unpaired, "broad phase"}}) {
        SCOPED_TRACE(stage);
        const auto scene = aslant_on_floor();
        FaultyWorld world(scene, does);
        const Blame blame = blame_of(world, scene, 16);
        EXPECT_EQ(blame.fault, fault);
        EXPECT_EQ(stage_of(blame.fault), stage);
        EXPECT_EQ(blame.other, Other::part(0));
        EXPECT_NEAR(blame.time, 0.2, 2 * blame_dt);
    }
}

TEST(Blame, AGateThatIsHeldOpenIsForTheGate) {
    const auto scene = std::make_shared<Scene>(empty_scene());
    add_part(*scene, {shape::Gate{{-10, 0}, {10, 0}, {0, 1}}});
    add_ball(*scene, {0, 0.5}, {1, -2});
    FaultyWorld world(scene, Does::open_gate);
    const Blame blame = blame_of(world, scene, 16);
    EXPECT_EQ(blame.fault, Fault::let_through);
    EXPECT_EQ(stage_of(blame.fault), "gate");
    EXPECT_EQ(blame.kind, "gate");
    EXPECT_NEAR(blame.time, 0.2, 2 * blame_dt);
}

TEST(Blame, ANormalThatIsTurnedIsOffByThatAngle) {
    const auto scene = aslant_on_floor();
    FaultyWorld world(scene, Does::turn_normal, 0.05);
    const Blame blame = blame_of(world, scene, 32);
    EXPECT_EQ(blame.fault, Fault::normal);
    expect_at_floor(blame);
    EXPECT_NEAR(blame.amount, 0.05, 1e-12);
}

TEST(Blame, AWeakerImpulseIsOffByWhatItLacks) {
    const auto scene = aslant_on_floor();
    FaultyWorld world(scene, Does::weaken, 0.1);
    const Blame blame = blame_of(world, scene, 32);
    EXPECT_EQ(blame.fault, Fault::impulse);
    expect_at_floor(blame);
    EXPECT_NEAR(blame.amount, 0.1 * 1.5 * 2, 1e-12);  // of (1 + e) v
}

TEST(Blame, ADelayIsLateByThatTime) {
    const auto scene = aslant_on_floor();
    FaultyWorld world(scene, Does::delay, 0.002);
    const Blame blame = blame_of(world, scene, 32);
    EXPECT_EQ(blame.fault, Fault::late);
    expect_at_floor(blame);
    EXPECT_NEAR(blame.amount, 0.002, 1e-12);
    FaultyWorld hasty(scene, Does::delay, -0.002);
    const Blame early = blame_of(hasty, scene, 32);
    EXPECT_EQ(early.fault, Fault::early);
    EXPECT_NEAR(early.amount, 0.002, 1e-12);
}

TEST(Blame, RubbingIsFrictionWhereThereIsSome) {
    const auto scene = aslant_on_floor(0.1);
    FaultyWorld world(scene, Does::rub, 0.3);
    const Blame blame = blame_of(world, scene, 32);
    EXPECT_EQ(blame.fault, Fault::friction);
    expect_at_floor(blame);
    EXPECT_NEAR(blame.amount, 0.3, 1e-12);
    FaultyWorld smooth(aslant_on_floor(), Does::rub, 0.3);  // nothing rubs: an untold normal
    EXPECT_EQ(blame_of(smooth, aslant_on_floor(), 32).fault, Fault::normal);
}

TEST(Blame, ABounceOffNothingIsAContactInvented) {
    const auto scene = aslant_on_floor();
    FaultyWorld world(scene, Does::bounce_off_nothing, 0, 0.05);
    const Blame blame = blame_of(world, scene, 32);
    EXPECT_EQ(blame.fault, Fault::invented);
    EXPECT_EQ(blame.other, Other::part(0));
    EXPECT_NEAR(blame.time, 4 * blame_dt, 1e-12);
}

TEST(Blame, ARunThatStopsIsTold) {
    const auto scene = aslant_on_floor();
    FaultyWorld world(scene, Does::refuse, 0, 0.05);
    const Blame blame = blame_of(world, scene, 32);
    EXPECT_EQ(blame.fault, Fault::stopped);
    EXPECT_NEAR(blame.time, 3 * blame_dt, 1e-12);
}

TEST(Blame, AFlipperThatStandsStillIsMistimed) {
    auto scene = std::make_shared<Scene>(empty_scene());
    Part& part = add_part(*scene, {shape::Flipper{{0, 0}, 1, 0.1, 0.1, 0}});
    part.motion = motion::Flip{Side::left, 1, 4, 4};
    add_ball(*scene, {0.8, 0.4}, {0, -0.1});
    FaultyWorld world(scene, Does::forget_flipper);
    world.apply(control::Flip{Side::left, true});
    const Blame blame = blame_of(world, scene, 16);
    EXPECT_EQ(blame.fault, Fault::motion);
    EXPECT_EQ(blame.kind, "flipper");
    EXPECT_EQ(blame.other, Other::part(0));
    EXPECT_NEAR(blame.amount, 4 * blame_dt, 1e-9);
}

/// The ball whose decision it is, not the one that ends worst because it was hit by it.
TEST(Blame, IsChargedToTheBallThatBeganIt) {
    const auto scene = aslant_on_floor();
    scene->balls[0].velocity = {0, -2};
    // Hit from below by the first ball on its way up, with ten times its reach in speed.
    add_ball(*scene, {0.02, 0.9}, {0, 0}, 0.1, 0.01);
    FaultyWorld world(scene, Does::weaken, 0.1);
    const Blame blame = blame_of(world, scene, 56);
    EXPECT_EQ(blame.fault, Fault::impulse);
    expect_at_floor(blame);
}

TEST(Blame, KindsAreThoseOfThePrimitiveThatIsMet) {
    const std::pair<Shape, const char*> shapes[] = {
        {{shape::Circle{{0, 0}, 0.5}}, "circle"},
        {{shape::Arc{{0, 0}, 0.5, 0, std::numbers::pi}}, "arc"},
        {{shape::Polygon{{{-1, -1}, {1, -1}, {1, 0.5}, {-1, 0.5}}}}, "polygon"},
        {{shape::Capsule{{-1, 0}, {1, 0}, 0.5}}, "taper"},
        {{shape::Polyline{{{-1, 0.5}, {0, 0.5}, {1, 0.5}}, false}}, "segment"},
        {{shape::Compound{{{shape::Point{{0, 0.5}}}, {shape::Circle{{0, -3}, 1}}}}}, "point"},
        {{shape::Gate{{1, 0.5}, {-1, 0.5}, {0, -1}}}, "gate"}};
    for (const auto& [shape, kind] : shapes) {
        const auto scene = std::make_shared<Scene>(empty_scene());
        add_part(*scene, shape);
        if (kind == std::string("gate")) std::get<shape::Gate>(scene->parts[0].shape.is).normal = {0, 1};
        add_ball(*scene, {0.01, 1}, {0, -2});
        FaultyWorld world(scene, Does::weaken, 0.1);
        const Blame blame = blame_of(world, scene, 32);
        EXPECT_EQ(blame.kind, kind);
        EXPECT_EQ(blame.fault, Fault::impulse) << kind;
    }
}

TEST(RunBlame, TellsTheFirstDivergenceOfALongRun) {
    const auto scene = std::make_shared<Scene>(empty_scene());
    add_part(*scene, segment({50, -10}, {50, 10}));
    add_ball(*scene, {0, 0}, {2000, 0});
    const auto run = [&](const char* solver) {
        const Engine& engine = engine_named("custom");
        Settings settings(engine.settings);
        settings.set("solver", solver);
        return blame_run(scene, {&engine, settings, "it", blame_dt}, 0.06, {}, [](double) {});
    };
    const RunBlame simple = run("simple");
    ASSERT_TRUE(simple.blame);
    EXPECT_EQ(simple.blame->fault, Fault::tunnelled);
    EXPECT_NEAR(simple.until, 2 * blame_dt, 1e-12);
    const RunBlame continuous = run("continuous");
    EXPECT_FALSE(continuous.blame);
    EXPECT_EQ(continuous.until, 0.06);
    EXPECT_EQ(continuous.why, "");
}

}  // namespace
}  // namespace flipside::lab

// All three engines on the same small scenes: one part of every kind in a walled box, a ball thrown at it
// from a random place. The first thing that the ball meets must be the same in all. (Whole scenes: sweep/
// agreement_test.cpp.)
//
// The custom engine, with its continuous solver, must agree with the exact one in every throw, in what is met
// and when: the times may differ by what rounding makes of the gap, divided by the speed at which it closes.
//
// Box2D, at its defaults, must agree within one step in time, since it only knows contacts per step. Left out
// of this are grazing hits: its continuous collision lets surfaces overlap by three slops before it stops a
// ball (b2TimeOfImpact's target: 0.015 units, 0.8 mm here) and so may miss a hit that never gets deeper: for
// a ball on a pin, one where the cosine between its way and the normal is below 0.35.

#include <algorithm>
#include <cstdio>
#include <functional>
#include <numbers>
#include <optional>
#include <random>
#include <sstream>

#include <gtest/gtest.h>

#include "in_small.hpp"
#include "lab/contenders/engines.hpp"

namespace flipside {
namespace {

using std::numbers::pi;

constexpr double dt = 1.0 / 60;
constexpr double radius = 0.0135;  // m, a pinball
constexpr double half_box = 0.25;  // m, from the middle to a wall
constexpr double grazing_cosine = 0.35;
constexpr double gap_rounding = 1e-14;  // m
constexpr int throws_per_kind = flipside::test::in_small ? 200 : 1000;

double uniform(std::mt19937_64& random, double low, double high) {
    return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
}

Part part(std::string name, Shape shape) {
    Part made;
    made.name = std::move(name);
    made.shape = std::move(shape);
    return made;
}

Ball ball_at(Vec2 position, Vec2 velocity) {
    Ball ball;
    ball.position = position;
    ball.velocity = velocity;
    ball.radius = radius;
    ball.mass = 0.08;
    return ball;
}

/// An elastic box around the origin without gravity: flights are straight, so only contacts can differ.
Scene walled_box() {
    Scene scene;
    scene.name = "cross-validation";
    scene.bounds = {{-1, -1}, {1, 1}};
    scene.materials = {Material{}};
    scene.layers = {"default"};
    const double h = half_box;
    scene.parts.push_back(part("walls", {shape::Polyline{{{-h, -h}, {h, -h}, {h, h}, {-h, h}}, true}}));
    return scene;
}

struct Kind {
    std::string name;
    std::function<void(Scene&)> add;
    bool flips = false;        ///< the left button is pressed when the ball is half way
    double surface_speed = 0;  ///< of the fastest point of the part, m/s
};

Part flipper() {
    Part made = part("flipper", {shape::Flipper{{-0.03, 0}, 0.07, 0.01, 0.006, -0.4}});
    made.motion = motion::Flip{Side::left, 0.5, 20, 12};
    return made;
}

Part turning(std::string name, Shape shape, double rate) {
    Part made = part(std::move(name), std::move(shape));
    made.motion = motion::Turn{{0.01, 0}, rate, true};
    return made;
}

const std::vector<Kind>& kinds() {
    const auto one = [](const Part& made) { return [made](Scene& scene) { scene.parts.push_back(made); }; };
    const shape::Segment segment{{-0.06, -0.03}, {0.05, 0.04}};
    const shape::Arc arc{{0, 0}, 0.06, 0.5, 4};
    static const std::vector<Kind> all = {
        {"point", one(part("point", {shape::Point{{0.01, 0.02}}}))},
        {"segment", one(part("segment", {segment}))},
        {"arc", one(part("arc", {arc}))},
        {"circle", one(part("circle", {shape::Circle{{0, 0.01}, 0.04}}))},
        {"polygon", one(part("polygon", {shape::Polygon{
                                            {{-0.05, -0.04}, {0.06, -0.02}, {0.03, 0.05}, {-0.04, 0.03}}}}))},
        {"capsule", one(part("capsule", {shape::Capsule{{-0.05, 0}, {0.04, 0.03}, 0.012}}))},
        {"flipper at rest", one(flipper())},
        {"flipper turning", one(flipper()), true, 20 * 0.076},
        {"polyline",
         one(part("polyline",
                  {shape::Polyline{{{-0.07, 0.04}, {-0.02, -0.04}, {0.03, 0.04}, {0.07, -0.03}}, false}}))},
        {"gate", one(part("gate", {shape::Gate{{-half_box, -0.01}, {half_box, 0.01}, unit({-0.04, 1})}}))},
        {"compound", one(part("compound", {shape::Compound{{{shape::Arc{{0, 0}, 0.05, 0, pi}},
                                                            {shape::Segment{{-0.05, 0}, {-0.05, -0.06}}},
                                                            {shape::Circle{{0.05, -0.03}, 0.015}}}}}))},
        {"turning segment", one(turning("vane", {segment}, 6)), false, 6 * 0.08},
        {"turning arc", one(turning("wheel", {arc}, -5)), false, 5 * 0.07},
        {"turning cup", one(turning("cup", {shape::Arc{{0.02, 0}, 0.05, 0.5, 5.5}}, 6)), false, 6 * 0.09},
        {"turning polygon",
         one(turning("bar",
                     {shape::Polygon{{{-0.07, -0.006}, {0.07, -0.006}, {0.07, 0.006}, {-0.07, 0.006}}}}, 8)),
         false, 8 * 0.08},
        {"ball", [](Scene& scene) { scene.balls.push_back(ball_at({0.01, -0.01}, {})); }},
    };
    return all;
}

std::ostream& operator<<(std::ostream& out, const Kind& kind) {
    return out << kind.name;
}

struct First {
    Other other;
    std::string name;
    int step;       ///< the one in which it was reported
    double time;    ///< s
    double speed;   ///< m/s, of the approach
    double cosine;  ///< that over the greatest speed possible: small where it grazes
};

/// What the thrown ball (the last of the scene) meets first.
std::optional<First> first_impact(const Kind& kind, const char* engine_name,
                                  const std::shared_ptr<const Scene>& scene, double flip_at) {
    const Engine& engine = lab::engine_named(engine_name);
    Settings settings = lab::settings_for(engine, *scene);
    if (engine.name == "custom") settings.set("solver", "continuous");
    const auto world = engine.make(scene, settings);
    const auto thrown = static_cast<BallNumber>(scene->balls.size() - 1);
    const double speed = length(scene->balls.back().velocity) + kind.surface_speed;
    for (int step = 0; step < 120; ++step) {
        if (flip_at >= 0 && step == static_cast<int>(flip_at / dt))
            world->apply(control::Flip{Side::left, true});
        world->step(dt);
        for (const Event& event : world->events()) {
            if (event.kind != EventKind::impact) continue;
            const bool with_ball = event.other == Other::ball(thrown);
            if (event.ball != thrown && !with_ball) continue;
            const std::string name = event.other.is_ball ? "ball" : scene->parts[event.other.index].name;
            return First{event.other, name, step, event.time, event.speed, event.speed / speed};
        }
    }
    return std::nullopt;
}

struct Throw {
    Vec2 from, velocity;
    double flip_at = -1;
};

/// From a circle around the part, aimed somewhere at it, slow enough that both engines look often.
Throw random_throw(std::mt19937_64& random, bool flips) {
    const Vec2 from = uniform(random, 0.16, 0.2) * from_angle(uniform(random, 0, 2 * pi));
    const Vec2 aim = {uniform(random, -0.07, 0.07), uniform(random, -0.05, 0.05)};
    const double speed = uniform(random, 0.4, 2);
    const double half_way = 0.5 * length(aim - from) / speed;
    return {from, speed * unit(aim - from), flips ? half_way : -1};
}

class CrossValidation : public testing::TestWithParam<Kind> {};

/// A throw and what came of it, for messages.
std::string text_of(const Kind& kind, int number, const Throw& thrown, const First& exact,
                    const First& other) {
    std::ostringstream text;
    text << kind.name << ' ' << number << ": from (" << thrown.from.x << ", " << thrown.from.y << ") at ("
         << thrown.velocity.x << ", " << thrown.velocity.y << ") m/s: the reference meets " << exact.name
         << " at " << exact.time << " s (cosine " << exact.cosine << "), the other " << other.name << " at "
         << other.time << " s (cosine " << other.cosine << ")";
    return text.str();
}

TEST_P(CrossValidation, FirstImpactAgrees) {
    const Kind& kind = GetParam();
    std::mt19937_64 random(20240607);
    int compared = 0, hits = 0, grazing = 0, parted = 0;
    double latest = 0;
    for (int i = 0; i < throws_per_kind; ++i) {
        const Throw thrown = random_throw(random, kind.flips);
        auto scene = std::make_shared<Scene>(walled_box());
        kind.add(*scene);
        scene->balls.push_back(ball_at(thrown.from, thrown.velocity));
        for (BallNumber n = 0; n < scene->balls.size(); ++n) scene->balls[n].number = n;

        const auto exact = first_impact(kind, "reference", scene, thrown.flip_at);
        const auto custom = first_impact(kind, "custom", scene, thrown.flip_at);
        const auto box2d = first_impact(kind, "box2d", scene, thrown.flip_at);
        ASSERT_TRUE(exact && custom && box2d) << kind.name << " " << i << ": a ball must meet something";
        const double late = std::abs(custom->time - exact->time);
        EXPECT_TRUE(custom->other == exact->other && late <= gap_rounding / exact->speed)
            << text_of(kind, i, thrown, *exact, *custom);
        latest = std::max(latest, late);

        const bool same = exact->other == box2d->other && std::abs(exact->step - box2d->step) <= 1;
        if (std::min(exact->cosine, box2d->cosine) < grazing_cosine) {
            ++grazing;
            parted += same ? 0 : 1;
            continue;
        }
        ++compared;
        hits += exact->name != "walls" ? 1 : 0;
        EXPECT_TRUE(same) << text_of(kind, i, thrown, *exact, *box2d);
    }
    std::printf(
        "%s: custom within %.1e s in all; box2d: %d of %d compared, %d met the part; %d grazing, %d of "
        "them differently\n",
        kind.name.c_str(), latest, compared, throws_per_kind, hits, grazing, parted);
    EXPECT_GE(compared, throws_per_kind / 2);
    EXPECT_GE(hits, throws_per_kind / 8) << "too few throws meet the part to say anything";
}

INSTANTIATE_TEST_SUITE_P(Kinds, CrossValidation, testing::ValuesIn(kinds()), [](const auto& test) {
    std::string name = test.param.name;
    std::replace(name.begin(), name.end(), ' ', '_');
    return name;
});

}  // namespace
}  // namespace flipside

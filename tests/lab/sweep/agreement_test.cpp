// The engines against the reference on every scene, in a few windows each: `flipside sweep` does the same
// with 500. The custom engine's continuous solver must agree in every impact, its time, the positions and
// the contacts, to 1e-9: both are exact but for rounding. Box2D must agree in what is hit first and in what
// touches then; what it may be off by is stated at each test.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

#include <gtest/gtest.h>

#include "lab/files/assets.hpp"
#include "lab/sweep/contenders.hpp"
#include "lab/sweep/measure.hpp"

namespace flipside::lab::sweep {
namespace {

constexpr double same_time = 1e-9;  // s

/// The impacts of a world over a window.
std::vector<Event> impacts_of(World& world, const Window& window, double dt) {
    std::vector<Event> impacts;
    world.restore(window.start);
    for (auto step = std::llround(window.seconds / dt); step > 0; --step) {
        world.step(dt);
        std::ranges::copy_if(world.events(), std::back_inserter(impacts),
                             [](const Event& event) { return event.kind == EventKind::impact; });
    }
    return impacts;
}

std::unique_ptr<World> world_of(const Contender& contender, const std::shared_ptr<const Scene>& scene) {
    return engine_named(contender.engine).make(scene, settings_of(contender, *scene));
}

/// A scene with a few windows of it, made once for all tests.
struct Sample {
    explicit Sample(const std::string& name) : variant(variants_of({name}, 0).front()), scene(load(variant)) {
        const bool slow = name == "bowl" || name == "rain";  // long rides, and many balls
        if (slow) variant.longest = variant.shortest;
        block = make_block({variant, 11, 0, slow ? 1U : 6U}, scene, reference_for(*scene), [] {});
    }
    Variant variant;
    std::shared_ptr<const Scene> scene;
    Block block;
};

class EverySceneAgrees : public testing::TestWithParam<std::string> {
  protected:
    static const Sample& sample() {
        static std::map<std::string, Sample> samples;
        return samples.try_emplace(GetParam(), GetParam()).first->second;
    }
    const std::shared_ptr<const Scene>& scene = sample().scene;
    const Block& block = sample().block;
};

TEST_P(EverySceneAgrees, WithTheContinuousSolver) {
    ASSERT_FALSE(block.windows.empty());
    const auto custom = world_of(contender_named("custom-continuous"), scene);
    const Truth truth = reference_for(*scene);
    const auto reference = truth.engine->make(scene, truth.trajectory);
    for (const double dt : {1.0 / 30, 1.0 / 60, 1.0 / 960})
        for (const Window& window : block.windows) {
            History history;
            const Outcome outcome = run_window(*custom, window, dt, history);
            EXPECT_EQ(outcome.failure, "");
            EXPECT_LE(outcome.error, exact_radii)
                << "dt " << dt << " from " << window.start.clock.time << " s";
            const double end = window.start.clock.time + window.seconds;
            const Unmatched unmatched =
                count_unmatched(window.impacts, impacts_of(*custom, window, dt), same_time, end);
            EXPECT_EQ(unmatched.first, 0U) << "dt " << dt << " from " << window.start.clock.time << " s";
            EXPECT_EQ(unmatched.second, 0U) << "dt " << dt << " from " << window.start.clock.time << " s";

            static_cast<void>(impacts_of(*reference, window, dt));
            const auto a = reference->contacts(), b = custom->contacts();
            ASSERT_EQ(a.size(), b.size());
            for (std::size_t i = 0; i < a.size(); ++i) {
                EXPECT_EQ(a[i].ball, b[i].ball);
                EXPECT_EQ(a[i].other, b[i].other);
                EXPECT_NEAR(a[i].separation, b[i].separation, exact_radii * window.ends.front().radius);
                EXPECT_LE(length(a[i].normal - b[i].normal), exact_radii);
            }
        }
}

// In double precision the reference claims no digit that 113 bits take back, and those of 113 bits are
// checked by 226.
TEST_P(EverySceneAgrees, TheReferenceWithItself) {
    const Engine& engine = engine_named("reference");
    const auto with = [&](std::string_view precision) {
        Settings settings = settings_for(engine, *scene);
        settings.set("precision", precision);
        settings.set("twin", "on");
        return engine.make(scene, settings);
    };
    const auto in_double = with("53"), exact = with("113");
    std::size_t claimed = 0;
    for (const Window& window : block.windows) {
        for (World* world : {in_double.get(), exact.get()}) {
            world->restore(window.start);
            world->step(window.seconds);
        }
        ASSERT_EQ(in_double->balls().size(), exact->balls().size());
        for (std::size_t i = 0; i < exact->balls().size(); ++i) {
            const double error = length(in_double->balls()[i].position - exact->balls()[i].position);
            EXPECT_LE(error, in_double->uncertainty()[i] + exact->uncertainty()[i]);
            claimed += in_double->uncertainty()[i] <= exact_radii * exact->balls()[i].radius ? 1U : 0U;
        }
    }
    EXPECT_GE(claimed, block.windows.size());
}

// Box2D may be late by
//   - one step, for it knows contacts per step alone,
//   - the three slops of 0.005 units that surfaces may overlap before it stops a ball (b2TimeOfImpact), and
//   - what its semi-implicit Euler flight is off by, ½·g·dt·t, on the way there,
// both divided by the approach speed. Left out are first hits that graze (see cross_validation_test.cpp) and
// those of balls that touch something when the window starts.
TEST_P(EverySceneAgrees, WithBox2dInTheFirstImpact) {
    constexpr double dt = 1.0 / 960, grazing_cosine = 0.35, slops = 3 * 0.005;
    const auto box2d = world_of(contender_named("box2d"), scene);
    int compared = 0, left_out = 0;
    for (const Window& window : block.windows) {
        const Event& first = window.impacts.front();
        const auto ball = std::ranges::find(window.start.balls, first.ball, &Ball::number);
        const double flown = first.time - window.start.clock.time;
        const double speed = length(ball->velocity + flown * scene->gravity);
        box2d->restore(window.start);
        const auto touching = box2d->contacts();
        if (std::ranges::find(touching, first.ball, &Contact::ball) != touching.end() ||
            first.other.is_ball || first.speed < grazing_cosine * speed) {
            ++left_out;
            continue;
        }
        const std::vector<Event> impacts = impacts_of(*box2d, window, dt);
        const auto same = std::ranges::find_if(impacts, [&](const Event& impact) {
            return impact.ball == first.ball && impact.other == first.other;
        });
        ++compared;
        ASSERT_NE(same, impacts.end()) << "from " << window.start.clock.time << " s: nothing is hit";
        const double units = 0.25 / ball->radius;  // Box2D units per metre: a diameter is 0.5
        const double late = slops / units + 0.5 * length(scene->gravity) * dt * flown;
        EXPECT_NEAR(same->time, first.time, dt + late / first.speed)
            << "from " << window.start.clock.time << " s";
    }
    std::printf("%s: %d first impacts compared, %d left out\n", GetParam().c_str(), compared, left_out);
}

const Contact* find_contact(std::span<const Contact> contacts, const Contact& like) {
    const auto at = std::ranges::find_if(
        contacts, [&](const Contact& c) { return c.ball == like.ball && c.other == like.other; });
    return at == contacts.end() ? nullptr : &*at;
}

// What touches whom at the moments of impacts. Balls then touch by rounding alone, which floats do not have:
// so Box2D gets the same states with balls a little larger. Every touch of the reference must then be an
// overlap of as much, and no overlap may be deeper, but for
//   - the rounding of positions to floats, 1e-3 radii, and
//   - where arcs are, their chords: `chord_error` in depth, and its √(2c/R) in the normal.
TEST_P(EverySceneAgrees, WithBox2dInTheContacts) {
    constexpr double swell = 0.02, rounding = 1e-3;  // radii
    constexpr double tightest = 0.034;               // m, of the arcs in our scenes
    constexpr std::size_t most = 20;                 // impacts of a window
    const Truth truth = reference_for(*scene);
    const auto reference = truth.engine->make(scene, truth.trajectory);
    const Settings settings = settings_of(contender_named("box2d"), *scene);
    const auto box2d = engine_named("box2d").make(scene, settings);
    const double chords = settings.real("chord_error"), turned = std::sqrt(2 * chords / tightest);
    std::size_t compared = 0;
    for (const Window& window : block.windows)
        for (const Event& impact : std::span(window.impacts).first(std::min(most, window.impacts.size()))) {
            reference->restore(window.start);
            reference->step(impact.time - window.start.clock.time);
            State state = reference->save();
            for (Ball& ball : state.balls) ball.radius *= 1 + swell;
            box2d->restore(state);
            const auto radius = [&](BallNumber number) {
                return std::ranges::find(reference->balls(), number, &Ball::number)->radius;
            };
            const auto reach = [&](const Contact& contact) {
                return radius(contact.ball) + (contact.other.is_ball ? radius(contact.other.index) : 0);
            };
            for (const Contact& contact : box2d->contacts())
                EXPECT_GE(contact.separation, -(swell + rounding) * reach(contact) - chords);
            for (const Contact& contact : reference->contacts()) {
                const Contact* const same = find_contact(box2d->contacts(), contact);
                ASSERT_NE(same, nullptr);
                EXPECT_NEAR(same->separation, contact.separation - swell * reach(contact),
                            rounding * reach(contact) + chords);
                EXPECT_LE(length(same->normal - contact.normal), rounding + turned);
                ++compared;
            }
        }
    std::printf("%s: %zu contacts compared\n", GetParam().c_str(), compared);
    EXPECT_GE(compared, block.windows.size());
}

INSTANTIATE_TEST_SUITE_P(Scenes, EverySceneAgrees, testing::ValuesIn(scene_names()),
                         [](const auto& test) { return test.param; });

}  // namespace
}  // namespace flipside::lab::sweep

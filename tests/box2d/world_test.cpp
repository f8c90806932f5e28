#include <algorithm>
#include <cstdio>

#include <gtest/gtest.h>

#include "box2d/table_top.hpp"
#include "world/input_error.hpp"

namespace flipside::box2d::test {
namespace {

TEST(Box2dWorld, dropBouncesNearlyToTheExactApexes) {
    // e = 0.8 from 1 m: apexes 0.64, 0.4096, 0.262144 m. Semi-implicit Euler falls short of the apex v²/2g
    // of each flight by v·h/2, which is g·h/v of it, and hands the loss on to the next.
    TableTop top;
    top.part(shape::Segment{{-1, 0}, {1, 0}}, top.material(0.8));
    top.ball({0, 1 + radius});
    const auto world = top.world();
    double apexes[3], low = 0, high = 0;
    int bounces = 0;
    run(*world, 3, [&] {
        if (count(world->events(), EventKind::impact) > 0) {
            if (bounces > 0 && bounces <= 3) apexes[bounces - 1] = high;
            ++bounces;
            high = 0;
        }
        high = std::max(high, world->balls()[0].position.y - radius);
        low = std::min(low, world->balls()[0].position.y - radius);
    });
    ASSERT_GE(bounces, 4);
    const double exact[3] = {0.64, 0.4096, 0.262144};
    double bound = 0;
    for (int i = 0; i < 3; ++i) {
        bound += 9.81 * frame / std::sqrt(2 * 9.81 * exact[i]);
        std::printf("apex %d: %.6f m, exact %.6f m, error %+.2f %%\n", i + 1, apexes[i], exact[i],
                    100 * (apexes[i] / exact[i] - 1));
        EXPECT_NEAR(apexes[i] / exact[i], 1, bound);
    }
    EXPECT_GT(low, -0.07 * radius);  // at most 3 slops of 0.005 units: 6 % of the radius, and rounding
}

TEST(Box2dWorld, ballComesToRestAndSleeps) {
    TableTop top;
    top.part(shape::Segment{{-1, 0}, {1, 0}}, top.material(0.5));
    top.ball({0, 0.1});
    const auto world = top.world();
    run(*world, 3);
    EXPECT_TRUE(world->balls()[0].asleep);
    EXPECT_EQ(world->balls()[0].velocity, Vec2{});
    EXPECT_NEAR(world->balls()[0].position.y, radius, 0.021 * radius);  // one slop is 2 % of the radius
    ASSERT_EQ(world->contacts().size(), 1U);
    EXPECT_NEAR(world->contacts()[0].normal.y, 1, 1e-6);
    EXPECT_EQ(world->statistics().asleep, 1U);
}

/// Balls among all sorts of parts, some moving, for two seconds and a bit.
TableTop busy() {
    TableTop top;
    top.scene.bounds = {{-0.3, -0.3}, {0.3, 0.3}};
    top.scene.gravity = {0, -1.11};
    const std::uint32_t wall = top.material(0.7, 0.1), bumper = top.material(0.9, 0, 1.5);
    top.part(shape::Polyline{{{-0.25, -0.25}, {0.25, -0.25}, {0.25, 0.25}, {-0.25, 0.25}}, true}, wall);
    top.part(shape::Circle{{-0.1, 0.05}, 0.03}, bumper);
    top.part(shape::Arc{{0.1, 0.1}, 0.05, 1, 4}, wall);
    top.part(shape::Segment{{-0.05, -0.1}, {0.05, -0.1}}, wall).motion = motion::Turn{{0, -0.1}, 3, true};
    Part& flipper = top.part(shape::Flipper{{-0.2, -0.15}, 0.08, 0.012, 0.007, -0.5}, wall);
    flipper.motion = motion::Flip{Side::left, 0.7, 25, 12};
    top.part(shape::Segment{{0, 0}, {0, 0.2}}).sensor = true;
    for (int row = 0; row < 2; ++row)
        for (int column = 0; column < 6; ++column)
            top.ball({-0.2 + 0.05 * column, 0.13 + 0.05 * row}, {0.25 * column - 0.6, 0.2 * row}, wall);
    return top;
}

TEST(Box2dWorld, twoRunsAreTheSameToTheBit) {
    const TableTop top = busy();
    const auto a = top.world(), b = top.world();
    for (int i = 0; i < 600; ++i) {
        if (i % 50 == 0) a->apply(control::Flip{Side::left, i % 100 == 0});
        if (i % 50 == 0) b->apply(control::Flip{Side::left, i % 100 == 0});
        a->step(frame);
        b->step(frame);
        static_cast<void>(b->contacts());  // looking changes nothing
        ASSERT_TRUE(std::ranges::equal(a->balls(), b->balls())) << i;
        ASSERT_EQ(a->events().size(), b->events().size());
    }
    EXPECT_EQ(a->balls().size(), 12U);
}

TEST(Box2dWorld, aRestoredStateReadsBackToTheBit) {
    const TableTop top = busy();
    const auto a = top.world(), b = top.world();
    run(*a, 2);
    State state = a->save();
    state.balls[0].position += Vec2{1e-13, 1e-13};  // more digits than a float has
    b->restore(state);
    EXPECT_TRUE(std::ranges::equal(b->balls(), state.balls));
    EXPECT_TRUE(std::ranges::equal(b->parts(), state.parts));
    EXPECT_EQ(b->time(), state.clock.time);
    EXPECT_TRUE(b->events().empty());
}

TEST(Box2dWorld, aRestoredWorldGoesOnAsTheFirstUpToWarmStarting) {
    // A state does not hold Box2D's impulses of the last step nor the order of its contacts, so the next
    // step is the same only as far as those do not matter: to the rounding of a float for balls in flight
    // (1e-6 units of 54 mm), and to a fiftieth of a radius for all.
    const TableTop top = busy();
    const auto a = top.world(), b = top.world();
    int flying = 0;
    for (int i = 0; i < 120; ++i) {
        a->step(frame);
        b->restore(a->save());
        std::vector<bool> touching(a->balls().size());
        for (const Contact& contact : a->contacts()) {
            touching[contact.ball] = true;
            if (contact.other.is_ball) touching[contact.other.index] = true;
        }
        a->step(frame);
        b->step(frame);
        for (const Event& event : a->events()) {
            touching[event.ball] = true;
            if (event.other.is_ball) touching[event.other.index] = true;
        }
        for (std::size_t k = 0; k < a->balls().size(); ++k) {
            const double apart = length(a->balls()[k].position - b->balls()[k].position) / radius;
            EXPECT_LT(apart, touching[k] ? 2e-2 : 1e-5) << "step " << i << ", ball " << k;
            flying += !touching[k];
        }
    }
    EXPECT_GT(flying, 500);
}

TEST(Box2dWorld, eventsDoNotBeginAgainAfterRestore) {
    TableTop top;
    top.part(shape::Segment{{-1, 0}, {1, 0}}, top.material(0));
    top.part(shape::Circle{{0, 0}, 0.1}).sensor = true;
    top.ball({0, 0.0134});
    const auto a = top.world(), b = top.world();
    run(*a, 0.1);
    b->restore(a->save());
    run(*b, 0.1, [&] { EXPECT_TRUE(b->events().empty()); });
}

TEST(Box2dWorld, inspectShowsWhatIsAskedFor) {
    struct Seen : Inspector {
        Topic topic{};
        int boxes = 0, pairs = 0, contacts = 0, circles = 0;
        bool wants(Topic t) const override { return t == topic; }
        void box(Topic, const Box&) override { ++boxes; }
        void pair(Vec2, Vec2) override { ++pairs; }
        void contact(const Contact&) override { ++contacts; }
        void circle(Topic, Vec2, double) override { ++circles; }
    };
    TableTop top;
    top.part(shape::Segment{{-1, 0}, {1, 0}}, top.material(0));
    top.ball({0, 0.0134});
    top.ball({0.5, 0.5});
    top.scene.gravity = {0, -1e-6};
    top.scene.balls[1].asleep = true;
    const auto world = top.world();
    const auto see = [&](Topic topic) {
        Seen seen;
        seen.topic = topic;
        world->inspect(seen);
        return seen;
    };
    EXPECT_EQ(see(Topic::boxes).boxes, 5);  // the edge, its two ends, two balls
    EXPECT_EQ(see(Topic::pairs).pairs, 1);
    EXPECT_EQ(see(Topic::contacts).contacts, 1);
    EXPECT_EQ(see(Topic::sleep).circles, 1);
    EXPECT_EQ(see(Topic::sleep).boxes, 0);
}

TEST(Box2dWorld, whatFloatsCannotHoldIsRefused) {
    TableTop top;
    top.ball({0, 0}, {1e30, 0});
    EXPECT_THROW((void)top.world(), InputError);
    top.scene.balls[0].velocity = {};
    top.scene.balls[0].mass = 1e-40;
    EXPECT_THROW((void)top.world(), InputError);
}

TEST(Box2dWorld, aSceneMayBeEmpty) {
    const auto world = TableTop().world();
    run(*world, 1);
    EXPECT_TRUE(world->balls().empty());
    EXPECT_NEAR(world->time(), 1, 1e-12);
}

}  // namespace
}  // namespace flipside::box2d::test

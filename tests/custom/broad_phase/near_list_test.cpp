// A list of near pairs, kept over many flights, answers what the broad phase would.

#include "custom/broad_phase/near_list.hpp"

#include <gtest/gtest.h>

#include "custom/scenes.hpp"
#include "rapidcheck/gtest.h"

namespace flipside::custom::test {
namespace {

Proxy any_proxy(bool ball) {
    const double x = *rc::gen::inRange(0, 40) * 0.25, y = *rc::gen::inRange(0, 40) * 0.25;
    return {bounds_of({x, y}, 0.5), 1, ~0U, ball, *rc::gen::inRange(0, 4) > 0};
}

RC_GTEST_PROP(NearList, AnswersAsTheBroadPhase, ()) {
    std::vector<Proxy> still, moving;
    for (int i = *rc::gen::inRange(0, 10); i > 0; --i)
        still.push_back(any_proxy(false)), still.back().active = false;
    for (int i = *rc::gen::inRange(1, 30); i > 0; --i) moving.push_back(any_proxy(i % 5 != 0));
    const auto broad = make_brute_force(still), twin = make_brute_force(still);
    NearList near(still);
    const double room = *rc::gen::inRange(0, 4) * 0.25;
    std::vector<Pair> found, expected;
    for (int step = 0; step < 8; ++step) {
        for (Proxy& proxy : moving) {
            const Vec2 by{*rc::gen::inRange(-1, 2) * 0.125, *rc::gen::inRange(-1, 2) * 0.125};
            proxy.box = {proxy.box.min + by, proxy.box.max + by};
            proxy.active = *rc::gen::inRange(0, 8) > 0;
        }
        near.find_pairs(
            moving, *broad, [&](std::size_t i) { return grown(moving[i].box, room); }, found);
        twin->find_pairs(moving, expected);
        RC_ASSERT(found == expected);
        near.find_pairs(moving, *broad, found);
        RC_ASSERT(found == expected);
    }
}

TEST(NearList, SearchesAgainOnlyWhenTheRoomIsLeft) {
    std::vector<Proxy> moving{{bounds_of({0, 0}, 1), 1, ~0U, true, true},
                              {bounds_of({3, 0}, 1), 1, ~0U, true, true}};
    const std::vector<Proxy> still;
    const auto broad = make_brute_force(still);
    NearList near(still);
    std::vector<Pair> pairs;
    const auto roomy = [&](std::size_t i) { return grown(moving[i].box, 1); };
    for (int i = 0; i < 12; ++i) {  // 1.2 m in all: the room of 1 m is left once
        near.find_pairs(moving, *broad, roomy, pairs);
        EXPECT_EQ(pairs.size(), i < 10 ? 0U : 1U);
        moving[0].box = bounds_of({0.1 * (i + 1) + 1e-9, 0}, 1);
    }
    EXPECT_EQ(broad->tests(), 2U);
}

TEST(NearList, RoomChangesNoBit) {
    Scene scene = empty_scene({0, -9.81});
    for (int i = 0; i < 60; ++i)
        add_ball(scene, {0.3 * (i % 10), 0.3 + 0.3 * (i / 10)}, {3 * std::sin(3.0 * i), std::cos(5.0 * i)});
    add_part(scene, {shape::Polyline{{{-0.5, -0.5}, {4, -0.5}, {4, 4}, {-0.5, 4}}, true}}, {"", 0.8, 0.1, 0});
    add_part(scene, {shape::Circle{{1.5, 0}, 0.2}}, {"", 0.8, 0, 5});
    add_part(scene, segment({2, 0.2}, {3, 0.2})).motion = motion::Turn{{2.5, 0.2}, 7, true};
    const auto state_with = [&](std::string_view room) {
        const auto world = make_world(scene, {{"search_room", room}, {"solver", "discrete"}});
        run(*world, 4);
        return world->save().balls;
    };
    const auto anew = state_with("0");
    EXPECT_EQ(state_with("1"), anew);
    EXPECT_EQ(state_with("100"), anew);
}

}  // namespace
}  // namespace flipside::custom::test

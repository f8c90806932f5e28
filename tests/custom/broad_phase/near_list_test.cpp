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

Box moved_by(const Box& box, Vec2 way) {
    return {box.min + way, box.max + way};
}

std::vector<Pair> near_pairs(NearList& near, const std::vector<Proxy>& moving, BroadPhase& broad,
                             double room) {
    const auto found =
        near.find_pairs(moving, broad, [&](std::size_t i) { return grown(moving[i].box, room); });
    return {found.begin(), found.end()};
}

RC_GTEST_PROP(NearList, AnswersAsTheBroadPhase, ()) {
    std::vector<Proxy> still, moving;
    for (int i = *rc::gen::inRange(0, 10); i > 0; --i)
        still.push_back(any_proxy(false)), still.back().active = false;
    for (int i = *rc::gen::inRange(1, 30); i > 0; --i) moving.push_back(any_proxy(i % 5 != 0));
    const auto broad = make_brute_force(still), twin = make_brute_force(still);
    NearList near(still);
    const double room = *rc::gen::inRange(0, 4) * 0.25;
    std::vector<Pair> expected;
    for (int step = 0; step < 8; ++step) {
        for (Proxy& proxy : moving) {
            const Vec2 by{*rc::gen::inRange(-1, 2) * 0.125, *rc::gen::inRange(-1, 2) * 0.125};
            proxy.box = moved_by(proxy.box, by);
            proxy.active = *rc::gen::inRange(0, 8) > 0;
        }
        if (*rc::gen::inRange(0, 4) == 0) moving.resize(moving.size() / 2);  // in the end none is left
        twin->find_pairs(moving, expected);
        RC_ASSERT(near_pairs(near, moving, *broad, room) == expected);
        RC_ASSERT(near_pairs(near, moving, *broad, 0) == expected);
    }
}

TEST(NearList, AllBallsMayLeave) {
    const std::vector<Proxy> still{{{{0, 0}, {16, 1}}, 1, ~0U, false, false}};
    for (const auto& broad :
         {make_brute_force(still), make_sweep(still), make_few(still, {{}, {16, 16}}),
          make_quadtree(still, {{}, {16, 16}}, 4), make_adaptive_quadtree(still, {{}, {16, 16}}, 4, 8),
          make_grid(still, {{}, {16, 16}}, 0)}) {
        NearList near(still);
        const std::vector<Proxy> moving{{bounds_of({3, 1}, 0.5), 1, ~0U, true, true}};
        EXPECT_EQ(near_pairs(near, moving, *broad, 0.1).size(), 1U) << broad->facts().name;
        EXPECT_EQ(near_pairs(near, {}, *broad, 0.1).size(), 0U) << broad->facts().name;
        EXPECT_EQ(near_pairs(near, moving, *broad, 0.1).size(), 1U) << broad->facts().name;
    }
}

// Of 256 balls up to four may leave before all are sought anew; here one to three do, some again and again.
TEST(NearList, SeeksThoseThatLeaveAlone) {
    constexpr double room = 0.1;
    const std::vector<Proxy> still{{{{0, 0}, {16, 1}}, 1, ~0U, false, false}};
    for (const auto& broad :
         {make_brute_force(still), make_sweep(still), make_few(still, {{}, {16, 16}}),
          make_quadtree(still, {{}, {16, 16}}, 4), make_adaptive_quadtree(still, {{}, {16, 16}}, 4, 8),
          make_grid(still, {{}, {16, 16}}, 0)}) {
        std::vector<Proxy> moving;
        for (int i = 0; i < 256; ++i)
            moving.push_back({bounds_of({0.5 + i % 16, 0.5 + i / 16}, 0.45), 1, ~0U, true, true});
        const auto twin = make_brute_force(still);
        NearList near(still);
        std::vector<Pair> expected;
        std::uint64_t searched = 0;
        for (int step = 0; step < 60; ++step) {
            for (const int mover : {7, 100, 100 + step % 3}) {
                Proxy& moved = moving[static_cast<std::size_t>(mover)];
                const Vec2 by{0.3 * std::sin(mover + step), 0.25 * std::cos(2.0 * step)};
                moved.box = moved_by(moved.box, by);
            }
            twin->find_pairs(moving, expected);
            EXPECT_EQ(near_pairs(near, moving, *broad, room), expected)
                << broad->facts().name << ", step " << step;
            if (step == 0) searched = broad->tests();
        }
        EXPECT_GT(expected.size(), 16U);
        if (broad->facts().name == "grid") {
            EXPECT_LT(broad->tests(), 40 * searched);
        }
    }
}

// A search by one broad phase leaves nothing behind that another would have to know.
RC_GTEST_PROP(NearList, BroadPhasesTakeTurns, ()) {
    std::vector<Proxy> still, moving;
    for (int i = *rc::gen::inRange(0, 10); i > 0; --i)
        still.push_back(any_proxy(false)), still.back().active = false;
    for (int i = *rc::gen::inRange(1, 30); i > 0; --i) moving.push_back(any_proxy(true));
    const auto twin = make_brute_force(still), few = make_few(still, {{}, {16, 16}}),
               grid = make_grid(still, {{}, {16, 16}}, 0);
    NearList near(still);
    std::vector<Pair> expected;
    for (int step = 0; step < 12; ++step) {
        Proxy& moved = moving[static_cast<std::size_t>(step) % moving.size()];
        const Vec2 by{*rc::gen::inRange(-1, 2) * 0.125, *rc::gen::inRange(-1, 2) * 0.125};
        moved.box = moved_by(moved.box, by);
        moved.active = true;
        twin->find_pairs(moving, expected);
        RC_ASSERT(near_pairs(near, moving, step % 3 == 0 ? *grid : *few, 0.1) == expected);
        // Every room that overlaps a box is found.
        std::vector<Handle> around;
        near.find_around(moved.box, step % 3 == 0 ? *grid : *few, around);
        for (Handle i = 0; i < moving.size(); ++i)
            if (overlap(moved.box, moving[i].box))
                RC_ASSERT(std::ranges::count(around, static_cast<Handle>(still.size()) + i) > 0);
    }
}

TEST(NearList, SearchesAgainOnlyWhenTheRoomIsLeft) {
    std::vector<Proxy> moving{{bounds_of({0, 0}, 1), 1, ~0U, true, true},
                              {bounds_of({3, 0}, 1), 1, ~0U, true, true}};
    const std::vector<Proxy> still;
    const auto broad = make_brute_force(still);
    NearList near(still);
    for (int i = 0; i < 12; ++i) {  // 1.2 m in all: the room of 1 m is left once
        EXPECT_EQ(near_pairs(near, moving, *broad, 1).size(), i < 10 ? 0U : 1U);
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
        const auto world = make_world(scene, {{"search_steps", room}, {"solver", "discrete"}});
        run(*world, 4);
        return world->save().balls;
    };
    const auto anew = state_with("1");
    EXPECT_EQ(state_with("2.5"), anew);
    EXPECT_EQ(state_with("100"), anew);
}

}  // namespace
}  // namespace flipside::custom::test

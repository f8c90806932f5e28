#include <filesystem>

#include <sys/wait.h>

#include "places.hpp"
#include "support.hpp"
#include "world/input_error.hpp"

namespace flipside::plugin {
namespace {

struct Misdeed {
    const char* does;
    const char* says;  ///< in the refusal; "" where there is none
};

void PrintTo(const Misdeed& misdeed, std::ostream* out) {
    *out << misdeed.does;
}

class Misbehaviour : public testing::TestWithParam<Misdeed> {};

/// Each keeps the contract until 0.1 s.
TEST_P(Misbehaviour, EndsTheRunByNameAndNothingElse) {
    const auto [does, says] = GetParam();
    const auto world = world_of(test::naughty_engine, falling(2), std::string("does=") + does);
    const auto other = world_of(test::naughty_engine, falling(2));
    const std::string refusal = refusal_of(*world);
    if (*says == '\0') {
        EXPECT_EQ(refusal, "");
        EXPECT_NEAR(world->balls()[0].position.y, 0.5 - 10 * 0.5 * 0.5 / 2, 1e-9);
        return;
    }
    EXPECT_TRUE(refusal.starts_with("custom-2: ")) << refusal;
    EXPECT_NE(refusal.find(says), std::string::npos) << refusal;
    for (const char c : refusal) EXPECT_FALSE(std::iscntrl(static_cast<unsigned char>(c))) << refusal;

    // The world is as it was before that step, and refuses every further one alike.
    EXPECT_NEAR(world->time(), 0.1, 1e-9);
    ASSERT_EQ(world->balls().size(), 2U);
    EXPECT_NEAR(world->balls()[0].position.y, 0.1 - 10 * 0.1 * 0.1 / 2, 1e-9);
    EXPECT_EQ(refusal_of(*world), refusal);

    // Another engine goes on from there, and so does this one once it has got a state.
    other->restore(world->save());
    EXPECT_EQ(refusal_of(*other), "");
    State earlier = world->save();
    earlier.clock = {};
    world->restore(earlier);
    world->step(0.01);
    EXPECT_NEAR(world->time(), 0.01, 1e-12);
}

constexpr Misdeed misdeeds[] = {
    {"crash", "has crashed (signal 11, Segmentation fault)"},
    {"abort", R"(it said last: "assertion failed: \x1b]0;owned\x07 the ball is round")"},
    {"hang", "has not answered for 10000 ms"},
    {"write-beyond", "has crashed (signal 11"},
    {"not-a-number", "ball 0 has a place, velocity, angle or spin that is no number"},
    {"far-away", "the farthest coordinate of a world is 1e+12 m"},
    {"too-many-balls", "says that there are 4000000000 balls; there are 2"},
    {"too-few-balls", "says that there are 0 balls; there are 2"},
    {"too-many-events", "says that there are 4000000000 events"},
    {"wrong-number", "gives a ball 1, where there is a ball 0"},
    {"event-of-nobody", "gives an event of ball 0 with part 1000"},
    {"events-in-disorder", "allowed are times in it, in order"},
    {"print", ""},
    {"shout", ""},
    {"exit", "has ended itself (exit code 0)"},
    {"fork", ""},
    {"leave-a-child", "has crashed (signal 9, Killed)"},
    {"write-to-socket", "has written nonsense into its socket"},
    {"close-socket", "has closed its socket"},
#ifndef FLIPSIDE_SANITIZED
    {"fill-memory", "has crashed (signal 6"},
#endif
    {"say-no", "refuses the step from 0.1 s: it is too late"},
};
INSTANTIATE_TEST_SUITE_P(Plugin, Misbehaviour, testing::ValuesIn(misdeeds), [](const auto& one) {
    std::string name = one.param.does;
    std::erase(name, '-');
    return name;
});

TEST(PluginMaking, WhatAnEngineRefusesIsBadInputAndACrashIsNot) {
    try {
        static_cast<void>(world_of(test::naughty_engine, falling(1), "does=refuse-make"));
        FAIL();
    } catch (const InputError& error) {
        EXPECT_STREQ(error.what(), R"(custom-2: refuses make at 0 s: no such luck\x1b[31m)");
    }
    try {
        static_cast<void>(world_of(test::naughty_engine, falling(1), "does=crash-in-make"));
        FAIL();
    } catch (const Refusal& refusal) {
        EXPECT_NE(std::string(refusal.what()).find("in make at 0 s its process has crashed"),
                  std::string::npos);
    }
}

std::size_t open_files() {
    std::size_t count = 0;
    for ([[maybe_unused]] const auto& file : std::filesystem::directory_iterator("/proc/self/fd")) ++count;
    return count;
}

TEST(PluginProcess, NothingIsLeftOfWorldsThatAreGone) {
    static_cast<void>(world_of(test::naughty_engine, falling(1)));
    const std::size_t before = open_files();
    for (int i = 0; i < 20; ++i) {
        const auto a = world_of(test::naughty_engine, falling(1)),
                   b = world_of(test::naughty_engine, falling(2), "does=crash");
        a->step(0.01);
        static_cast<void>(refusal_of(*b));
        a->step(0.01);
        EXPECT_NEAR(a->time(), 0.02, 1e-12);
    }
    EXPECT_EQ(open_files(), before);
    // No child is left, dead or alive.
    EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1);
    EXPECT_EQ(errno, ECHILD);
}

}  // namespace
}  // namespace flipside::plugin

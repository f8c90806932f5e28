#include "lab/comparison/live_match.hpp"

#include <gtest/gtest.h>

#include "lab/comparison/impact.hpp"
#include "lab/contenders/engines.hpp"
#include "lab/files/assets.hpp"
#include "lab/session/run.hpp"
#include "world/scene_file.hpp"

namespace flipside::lab {
namespace {

TEST(LiveMatch, WaitsForTheOtherRunAsLongAsTheToleranceAllows) {
    LiveMatch match;
    const std::vector early{impact(1, 0, 3)}, late{impact(1.09, 0, 3)};
    match.observe(early, {}, 0.1, 1.05);
    match.observe({}, late, 0.1, 1.1);
    EXPECT_FALSE(match.parting());
    match.observe({}, std::vector{impact(2, 0, 4)}, 0.1, 2);
    match.observe({}, {}, 0.1, 2.1);
    EXPECT_FALSE(match.parting());
    match.observe({}, {}, 0.1, 2.11);
    ASSERT_TRUE(match.parting());
    EXPECT_EQ(match.parting()->time, 2);
    EXPECT_EQ(match.parting()->index, 1U);
    EXPECT_FALSE(match.parting()->first);
}

TEST(LiveMatch, TakesTheEarlierOfTwoThoughItIsFoundLater) {
    LiveMatch match;
    match.observe(std::vector{impact(1, 1, 3), impact(1.04, 0, 3)}, std::vector{impact(1.04, 0, 4)}, 0.1,
                  1.05);
    ASSERT_TRUE(match.parting());
    EXPECT_EQ(match.parting()->ball, 0U);
    match.observe({}, {}, 0.1, 1.15);
    EXPECT_EQ(match.parting()->ball, 1U);
    EXPECT_EQ(match.parting()->time, 1);
}

TEST(LiveMatch, FindsWhatMatchImpactsFindsAfterwards) {
    constexpr double dt = 1.0 / 60, tolerance = dt * (1 + 1e-9);
    for (const char* name : {"toy", "bowl", "rain"}) {
        const auto scene = std::make_shared<const Scene>(load_scene(scene_file(name)));
        std::vector<Session> sessions;
        for (const char* engine : {"custom", "box2d"})
            sessions.emplace_back(scene, engine_named(engine), settings_for(engine_named(engine), *scene));
        LiveMatch live;
        std::vector<Event> all[2];
        const Timeline timeline(0, 1.5, dt);
        run(sessions, timeline, {}, [&](const Session& session, std::uint64_t, double time) {
            const bool second = &session == &sessions[1];
            all[second].insert(all[second].end(), session.events().begin(), session.events().end());
            if (second) live.observe(sessions[0].events(), session.events(), tolerance, time);
        });
        const auto parting = match_impacts(all[0], all[1], tolerance, timeline.end()).parting;
        ASSERT_EQ(live.parting().has_value(), parting.has_value()) << name;
        if (!parting) continue;
        EXPECT_EQ(live.parting()->time, parting->time) << name;
        EXPECT_EQ(live.parting()->ball, parting->ball) << name;
        EXPECT_EQ(live.parting()->index, parting->index) << name;
    }
}

}  // namespace
}  // namespace flipside::lab

#include "app/window/playfield/captions.hpp"

#include <gtest/gtest.h>

namespace flipside::app {
namespace {

constexpr PartIndex target_a = 0, target_b = 1, lane_a = 2, lane_b = 3;

Scene captioned_scene() {
    Scene scene;
    scene.parts.resize(4);
    scene.rules.emplace();
    scene.rules->targets = {{{target_a, target_b}, 2000}};
    scene.rules->lanes = {{{lane_a, lane_b}, 500}};
    scene.rules->end_bonus = {{{target_a, 1200}}, 3};
    return scene;
}

class Captions : public testing::Test {
  protected:
    void hit(double time, std::initializer_list<PartIndex> parts) {
        std::vector<Event> events;
        for (const PartIndex part : parts)
            events.push_back({time, EventKind::impact, 0, Other::part(part), {}, {}, 1, 0});
        static_cast<void>(game.observe(events, time, balls));
    }
    void enter() {
        game.applied(control::Launch{}, 0);
        balls.resize(1);
        hit(0, {});
    }
    void drain(double time) {
        balls.clear();
        const Event lost{time, EventKind::lost, 0, {}, {}, {}, 0, 0};
        static_cast<void>(game.observe({&lost, 1}, time, balls));
    }
    [[nodiscard]] std::string at(double time) const {
        const auto words = caption_of(game, time);
        return words ? words->title + "|" + words->detail : "";
    }

    lab::Game game{std::make_shared<const Scene>(captioned_scene())};
    std::vector<Ball> balls;
};

TEST_F(Captions, SayWhatHappenedForAWhile) {
    enter();
    EXPECT_EQ(at(0), "");
    hit(1, {target_a});
    EXPECT_EQ(at(1), "Targets 1 of 2|");
    EXPECT_EQ(at(2.3), "Targets 1 of 2|");
    EXPECT_EQ(at(2.5), "");
    EXPECT_LT(caption_of(game, 2.35)->strength, caption_of(game, 2.2)->strength);
    EXPECT_EQ(at(0.9), "");  // in the past of it
}

TEST_F(Captions, OfSeveralTheOneOfHighestRankIsShown) {
    enter();
    hit(1, {target_a, target_b});
    EXPECT_EQ(at(1), "Targets down|+2,000");
    hit(1.5, {lane_a});
    EXPECT_EQ(at(1.5), "Targets down|+2,000");
    hit(3, {lane_b});
    EXPECT_EQ(at(3), "Targets down|+2,000");
    EXPECT_EQ(at(4), "Lanes lit|+500  ·  bonus × 2");
}

TEST_F(Captions, TheBonusIsCounted) {
    enter();
    hit(1, {target_a, lane_a, lane_b});
    hit(2, {lane_a, lane_b});
    drain(10);
    EXPECT_EQ(at(10), "Bonus 1,200|1,200 × 1");
    EXPECT_EQ(at(10.5), "Bonus 2,400|1,200 × 2");
    EXPECT_EQ(at(12), "Bonus 3,600|1,200 × 3");
}

TEST_F(Captions, ATiltStaysUntilTheBallIsLost) {
    enter();
    for (const double time : {1.0, 1.1}) game.applied(control::Nudge{}, time);
    EXPECT_EQ(at(1.2), "Careful|one more nudge tilts the table");
    EXPECT_TRUE(caption_of(game, 1.2)->warns);
    game.applied(control::Nudge{}, 1.2);
    EXPECT_EQ(at(1.3), "Tilt|until this ball is lost");
    EXPECT_EQ(at(60), "Tilt|until this ball is lost");
    drain(60);
    EXPECT_EQ(at(60), "");
}

}  // namespace
}  // namespace flipside::app

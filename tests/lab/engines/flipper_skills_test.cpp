/// What a player learns to do with flippers is possible on the pinball table, on both engines: a ball is
/// held, is caught as it comes down, and is passed from one flipper to the other. Times are tried in steps of
/// 2 ms; a few of them in a row are what a practised hand can meet.

#include <functional>

#include <gtest/gtest.h>

#include "in_small.hpp"
#include "lab/contenders/engines.hpp"
#include "lab/files/assets.hpp"
#include "lab/session/run_settings.hpp"
#include "lab/session/session.hpp"
#include "world/scene_file.hpp"

namespace flipside::lab {
namespace {

constexpr double between_tries = 0.002;  // s

class FlipperSkills : public testing::TestWithParam<const char*> {
  protected:
    [[nodiscard]] Session table_with_ball(Vec2 place, Vec2 velocity) const {
        Scene scene = load_scene(scene_file("pinball"));
        Ball ball = scene.launcher->ball;
        ball.position = place;
        ball.velocity = velocity;
        scene.balls = {ball};
        const Engine& engine = engine_named(GetParam());
        const Settings settings = settings_for(engine, scene);
        return {std::make_shared<const Scene>(std::move(scene)), engine, settings};
    }
    /// With the left flipper up since the ball rolled down its inlane.
    [[nodiscard]] Session with_held_ball() const {
        Session session = table_with_ball({0.055, 0.3}, {});
        play(session, {{0, control::Flip{Side::left, true}}}, 5);
        return session;
    }
    static void play(Session& session, const Script& script, double seconds) {
        std::size_t next = 0;
        for (int i = 0; i < 60 * seconds; ++i) session.step(1.0 / 60, script, next);
    }
    /// In the corner between a raised flipper and its inlane, at rest.
    static bool holds(const Session& session, Side side) {
        const auto balls = session.world().balls();
        if (balls.empty()) return false;
        constexpr double width = 0.484;
        const Vec2 at = balls[0].position;
        const double x = side == Side::left ? at.x : width - at.x;
        return length(balls[0].velocity) < 0.02 && x > 0.12 && x < 0.19 && at.y > 0.18 && at.y < 0.24;
    }
    /// The longest row of times from `from` to `to` at which it succeeds, s.
    static double window(double from, double to, const std::function<bool(double)>& succeeds) {
        int row = 0, longest = 0;
        for (int i = 0; from + i * between_tries < to; ++i) {
            row = succeeds(from + i * between_tries) ? row + 1 : 0;
            longest = std::max(longest, row);
        }
        return longest * between_tries;
    }
};

TEST_P(FlipperSkills, ARaisedFlipperHoldsABallForAsLongAsItIsHeld) {
    Session session = with_held_ball();
    EXPECT_TRUE(holds(session, Side::left));
    play(session, {}, 30);
    EXPECT_TRUE(holds(session, Side::left));
    EXPECT_EQ(session.game().searches(), 0);  // for it is not lost
}

/// A ball that crosses over low from the other side bounces away from a flipper that is up. Raised as it
/// comes, the flipper takes it; for how long that works depends on the ball, so the widest of several counts.
TEST_P(FlipperSkills, ABallCanBeCaughtByRaisingTheFlipperAsItComes) {
    const struct {
        Vec2 place, velocity;
    } balls[] = {{{0.261, 0.239}, {-0.651, -0.361}},
                 {{0.262, 0.234}, {-0.651, -0.326}},
                 {{0.251, 0.228}, {-0.575, -0.289}}};
    double widest = 0;
    for (const auto& [place, velocity] : balls) {
        const auto held_after = [&, at = place, moves = velocity](const Script& script) {
            Session session = table_with_ball(at, moves);
            play(session, script, 3);
            return holds(session, Side::left);
        };
        EXPECT_FALSE(held_after({}));
        if (held_after({{0, control::Flip{Side::left, true}}})) continue;
        widest = std::max(widest, window(0.04, 0.26, [&](double time) {
                              return held_after({{time, control::Flip{Side::left, true}}});
                          }));
    }
    RecordProperty("window_ms", std::to_string(1000 * widest));
    EXPECT_GE(widest, 0.03);
}

/// A ball that flies in faster than it rolls bounces off a flipper that was up before, and off one that is
/// down; raised at its time, the flipper takes it (players call it a live catch).
TEST_P(FlipperSkills, AFastBallCanBeCaughtAlive) {
    double narrowest = 1;
    for (const double x : {0.17, 0.18, 0.19, 0.2}) {
        if (test::in_small && x != 0.18) continue;
        const Vec2 velocity{-0.8, -0.4}, place{x - 0.2 * velocity.x, 0.17 - 0.2 * velocity.y};
        const auto held_after = [&](const Script& script) {
            Session session = table_with_ball(place, velocity);
            play(session, script, 3);
            return holds(session, Side::left);
        };
        EXPECT_FALSE(held_after({{0, control::Flip{Side::left, true}}})) << x;
        narrowest = std::min(narrowest, window(0, 0.3, [&](double time) {
                                 return held_after({{time, control::Flip{Side::left, true}}});
                             }));
    }
    RecordProperty("window_ms", std::to_string(1000 * narrowest));
    EXPECT_GE(narrowest, 0.04);
}

/// The flipper falls away below the ball and takes its speed, then comes up again and holds it.
TEST_P(FlipperSkills, ABallCanBeCaughtByDroppingAFlipperThatIsUp) {
    double widest = 0;
    for (const double x : {0.17, 0.18, 0.19})
        for (const Vec2 velocity : {Vec2{-0.3, -1.2}, Vec2{-0.6, -1.2}, Vec2{0, -1.6}}) {
            const Vec2 place{x - 0.2 * velocity.x, 0.17 - 0.2 * velocity.y};
            const auto held_after = [&](const Script& script) {
                Session session = table_with_ball(place, velocity);
                play(session, script, 3);
                return holds(session, Side::left);
            };
            if (held_after({{0, control::Flip{Side::left, true}}})) continue;
            widest = std::max(widest, window(0.08, 0.2, [&](double time) {
                                  return held_after({{0, control::Flip{Side::left, true}},
                                                     {time, control::Flip{Side::left, false}},
                                                     {time + 0.12, control::Flip{Side::left, true}}});
                              }));
        }
    RecordProperty("window_ms", std::to_string(1000 * widest));
    EXPECT_GE(widest, 0.016);
}

/// The flipper is let fall under a ball that it held, and the ball rolls down it; a tap before it comes to
/// the tip sends it across to the other flipper, which holds it.
TEST_P(FlipperSkills, ATapPassesAHeldBallToTheOtherFlipper) {
    constexpr double tap = 0.02;  // s
    const Session held = with_held_ball();
    const double wide = window(0.15, 0.35, [&](double delay) {
        Session session = held.fork();
        const double now = session.world().time();
        play(session,
             {{now, control::Flip{Side::left, false}},
              {now, control::Flip{Side::right, true}},
              {now + delay, control::Flip{Side::left, true}},
              {now + delay + tap, control::Flip{Side::left, false}}},
             4);
        return holds(session, Side::right);
    });
    RecordProperty("window_ms", std::to_string(1000 * wide));
    EXPECT_GE(wide, 0.02);
}

/// Balanced on the round end of a lane guide it would stay for ever.
TEST_P(FlipperSkills, ABallThatLiesOnAGuideIsShakenLoose) {
    Session session = table_with_ball({0.218, 0.926 + 0.005 + 0.0135}, {});
    const double patience = session.scene().rules->ball_search;
    play(session, {}, patience - 0.1);
    ASSERT_FALSE(session.world().balls().empty());
    EXPECT_GT(session.world().balls()[0].position.y, 0.94);
    EXPECT_EQ(session.game().searches(), 0);
    play(session, {}, 4.1);
    EXPECT_EQ(session.game().searches(), 1);
    EXPECT_TRUE(session.world().balls().empty() || session.world().balls()[0].position.y < 0.9);
    EXPECT_FALSE(session.game().tilted());
}

INSTANTIATE_TEST_SUITE_P(OnBothEngines, FlipperSkills, testing::Values("custom", "box2d"));

}  // namespace
}  // namespace flipside::lab

/// A whole game with multiball in it, on the engines.

#include <gtest/gtest.h>

#include "lab/bot/play.hpp"
#include "lab/contenders/engines.hpp"
#include "lab/files/assets.hpp"
#include "lab/replay/play.hpp"
#include "lab/session/run_settings.hpp"
#include "world/scene_file.hpp"

namespace flipside::lab {
namespace {

class Multiball : public testing::TestWithParam<const char*> {
  protected:
    Multiball() : request(request_on(GetParam())) {}
    static bot::Request request_on(const char* name) {
        const auto scene = std::make_shared<const Scene>(load_scene(scene_file("pinball")));
        const Engine& engine = engine_named(name);
        return {scene, &engine, settings_for(engine, *scene)};
    }
    [[nodiscard]] Session new_session() const { return {request.scene, *request.engine, request.settings}; }
    /// The first of the bot's games that comes to multiball.
    [[nodiscard]] bot::Played with_multiball() const {
        for (std::uint64_t seed = 1; seed < 50; ++seed) {
            bot::Played played = bot::play(request, seed);
            Session session = new_session();
            if (until_multiball(session, played)) return played;
        }
        throw std::runtime_error("none");
    }
    bool until_multiball(Session& session, const bot::Played& played) const {
        next = 0;
        while (session.world().time() < played.seconds - 1) {
            session.step(request.dt, played.script, next);
            if (session.game().turns().multiball()) return true;
        }
        return false;
    }
    void to_end(Session& session, const bot::Played& played) const {
        while (!session.game().over() && session.world().time() < played.seconds + 1)
            session.step(request.dt, played.script, next);
    }

    bot::Request request;
    mutable std::size_t next = 0;
};

TEST_P(Multiball, BringsItsBallsAndCostsNone) {
    const bot::Played played = with_multiball();
    Session session = new_session();
    ASSERT_TRUE(until_multiball(session, played));
    const int left = session.game().balls_left();
    std::size_t most = 0;
    for (int i = 0; i < 10 * 60 && session.game().turns().multiball(); ++i) {
        session.step(request.dt, played.script, next);
        most = std::max(most, session.world().balls().size());
    }
    EXPECT_EQ(most, 3U);
    EXPECT_EQ(session.game().balls_left(), left);
}

TEST_P(Multiball, GoesOnFromASnapshotAsItDid) {
    const bot::Played played = with_multiball();
    Session session = new_session();
    ASSERT_TRUE(until_multiball(session, played));
    for (int i = 0; i < 90; ++i) session.step(request.dt, played.script, next);
    const Session::Snapshot middle = session.snapshot(session.events());
    const std::size_t from = next;
    Session once = new_session(), again = new_session();
    once.restore(middle);
    to_end(once, played);
    next = from;
    again.restore(middle);
    to_end(again, played);
    EXPECT_TRUE(once.game().over());
    EXPECT_EQ(once.game().score(), again.game().score());
    EXPECT_EQ(once.world().time(), again.world().time());
    EXPECT_EQ(once.game().captions(), again.game().captions());
    if (!request.engine->restores_exactly) return;
    EXPECT_EQ(once.game().score(), played.score);
}

TEST_P(Multiball, ReplaysToTheBit) {
    const bot::Played played = with_multiball();
    Session session = new_session();
    next = 0;
    to_end(session, played);
    EXPECT_EQ(session.game().score(), played.score);
    const RecordedRun run{"game", &session, request.dt};
    const Replay replay = parse_replay(to_json(replay_of({&run, 1})), "game.flipside-replay");
    ReplayPlayer player(replay, 0);
    while (player.step()) {
    }
    EXPECT_FALSE(player.parting());
    EXPECT_EQ(player.session().game().score(), played.score);
    EXPECT_EQ(player.session().game().captions(), session.game().captions());
}

INSTANTIATE_TEST_SUITE_P(OnBothEngines, Multiball, testing::Values("custom", "box2d"));

}  // namespace
}  // namespace flipside::lab

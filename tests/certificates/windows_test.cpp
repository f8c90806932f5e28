// Certificates of short windows along a run of every shipped scene are accepted.
// FLIPSIDE_CERTIFIED_WINDOWS=500 build/release/tests/certificates/test_certificates
// --gtest_filter='*Windows*' takes as many of each and prints the figures.

#include <cstdlib>

#include "checking.hpp"
#include "in_small.hpp"
#include "lab/session/run.hpp"
#include "world/refusal.hpp"
#include "world/schema.hpp"

namespace flipside {
namespace {

constexpr double window = 0.2, apart = 0.1;  // s

class Windows : public ::testing::TestWithParam<std::string> {};

struct Tally {
    int accepted = 0, cut = 0, not_isolated = 0;
};

/// Along a run, until there are so many or the reference refuses to go on.
void take_windows(const Shipped& shipped, double gap, int most, Tally& tally) {
    lab::Session way = shipped.session("53");
    const lab::Watcher nothing = [](const lab::Session&, std::uint64_t, double) {};
    try {
        while (tally.accepted < most) {
            lab::Session session = shipped.session("113");
            session.restore(way.world().save());
            const lab::Certified certified = shipped.certified(session, window);
            check_form(parse_json(certified.json, "certificate"), certificate_schema, "certificate");
            const Checked checked = check_certificate(certified.json);
            ASSERT_EQ(checked.code, 0) << "the window from " << way.world().time() << " s: " << checked.says;
            ++tally.accepted;
            tally.cut += !certified.ends.empty();
            const std::string words = "uncertified: ";
            tally.not_isolated += std::atoi(checked.says.c_str() + checked.says.find(words) + words.size());
            const lab::Timeline next(way.world().time(), gap, lab::default_step);
            lab::run({&way, 1}, next, shipped.script, nothing);
        }
    } catch (const Refusal& refusal) {
        std::printf("at %.3f s: %s\n", way.world().time(), refusal.what());
    }
}

TEST_P(Windows, OfAShippedSceneAreAccepted) {
    const char* many = std::getenv("FLIPSIDE_CERTIFIED_WINDOWS");
    const int most = many != nullptr ? std::atoi(many) : test::in_small ? 3 : 8;
    Tally tally;
    // The balls of rain heap up after a while; then it begins again with others.
    for (int balls = 30; tally.accepted < most && balls > 0 && !HasFatalFailure(); --balls)
        take_windows(Shipped(GetParam(), balls), many != nullptr ? apart : 4 * apart, most, tally);
    std::printf("%s: %d windows accepted, %d of them end early, %d impacts without isolating interval\n",
                GetParam().c_str(), tally.accepted, tally.cut, tally.not_isolated);
    EXPECT_GE(tally.accepted, most);
}

INSTANTIATE_TEST_SUITE_P(EveryScene, Windows, ::testing::ValuesIn(lab::scene_names()),
                         [](const auto& scene) { return scene.param; });

}  // namespace
}  // namespace flipside

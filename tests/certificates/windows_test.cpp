// Certificates of short windows along a run of every shipped scene are accepted.
// FLIPSIDE_CERTIFIED_WINDOWS=500 build/release/tests/certificates/test_certificates
// --gtest_filter='*Windows*' takes as many of each and prints the figures.

#include <cstdlib>

#include "checking.hpp"
#include "lab/run.hpp"
#include "world/refusal.hpp"
#include "world/schema.hpp"

namespace flipside {
namespace {

constexpr double window = 0.2, apart = 0.1;  // s

class Windows : public ::testing::TestWithParam<std::string> {};

TEST_P(Windows, OfAShippedSceneAreAccepted) {
    const char* many = std::getenv("FLIPSIDE_CERTIFIED_WINDOWS");
    const int most = many != nullptr ? std::atoi(many) : 8;
    const Shipped shipped(GetParam());
    lab::Session way = shipped.session("53");
    int accepted = 0, cut = 0, not_isolated = 0;
    std::string refusal;
    while (accepted < most) {
        lab::Session session = shipped.session("113");
        session.restore(way.world().save());
        lab::Certified certified;
        try {
            certified = shipped.certified(session, window);
        } catch (const Refusal& refused) {
            refusal = refused.what();
            break;
        }
        check_form(parse_json(certified.json, "certificate"), certificate_schema, "certificate");
        const Checked checked = check_certificate(certified.json);
        ASSERT_EQ(checked.code, 0) << "the window from " << way.world().time() << " s: " << checked.says;
        ++accepted;
        cut += !certified.ends.empty();
        const std::string words = "uncertified: ";
        not_isolated += std::atoi(checked.says.c_str() + checked.says.find(words) + words.size());
        try {
            const lab::Timeline next(way.world().time(), many != nullptr ? apart : 4 * apart,
                                     lab::default_step);
            lab::run({&way, 1}, next, shipped.script, [](const lab::Session&, std::uint64_t, double) {});
        } catch (const Refusal& refused) {
            refusal = refused.what();
            break;
        }
    }
    std::printf("%s: %d windows accepted, %d of them end early, %d impacts without isolating interval%s%s\n",
                GetParam().c_str(), accepted, cut, not_isolated,
                refusal.empty() ? "" : "; then: ", refusal.c_str());
    EXPECT_GT(accepted, 2);
}

INSTANTIATE_TEST_SUITE_P(EveryScene, Windows, ::testing::ValuesIn(lab::scene_names()),
                         [](const auto& scene) { return scene.param; });

}  // namespace
}  // namespace flipside

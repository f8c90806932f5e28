#include "lab/regimes/measure.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "lab/process/failure.hpp"
#include "world/scene_builder.hpp"

namespace flipside::lab::regimes {
namespace {

/// Two balls fall onto a floor, which they reach after 0.45 s.
Course falling() {
    Scene scene = empty_scene({0, -9.81});
    scene.materials[0].restitution = 0.5;
    add_ball(scene, {0, 1.1});
    add_ball(scene, {1, 1.1});
    add_part(scene, segment({-5, 0}, {5, 0}));
    const auto shared = std::make_shared<const Scene>(scene);
    return {2,
            [shared] { return std::vector<std::shared_ptr<const Scene>>{shared}; },
            {{"in flight", 0, 0.25, true}, {"hitting", 0.25, 0.5}, {"all of it", 0, 0.75}}};
}

TEST(Regimes, EveryKindIsMeasuredInEveryRegimeAsOften) {
    const auto all = kinds();
    const auto results = measure(falling(), all, {.repeats = 3});
    ASSERT_EQ(results.size(), 3 * all.size());
    for (std::size_t i = 0; i < results.size(); ++i) {
        const Result& result = results[i];
        EXPECT_EQ(result.regime, falling().regimes[i / all.size()].name);
        EXPECT_EQ(result.kind.name, all[i % all.size()].name);
        EXPECT_EQ(result.is_kind, i < all.size());
        EXPECT_EQ(result.failure, "");
        ASSERT_EQ(result.nanoseconds.size(), 3U);
        EXPECT_GT(std::ranges::min(result.nanoseconds), 0) << result.kind.name;
        EXPECT_EQ(result.lost, 0U);
    }
}

TEST(Regimes, ErrorsAreThoseAgainstTheReference) {
    const auto results = measure(falling(), kinds(), {.repeats = 1});
    const auto of = [&](const std::string& regime, const std::string& kind) {
        return *std::ranges::find_if(
            results, [&](const Result& r) { return r.regime == regime && r.kind.name == kind; });
    };
    EXPECT_LT(of("hitting", "custom-continuous").error.value(), 1e-12);
    // Semi-implicit Euler is off a parabola by g·dt·t/2 after t: here 0.1 s, in radii of 0.1 m.
    EXPECT_NEAR(of("in flight", "box2d").error.value(), 9.81 / 60 * 0.1 / 2 / 0.1, 1e-3);
    EXPECT_FALSE(of("in flight", "bare-loop").error.has_value());
    EXPECT_GT(of("in flight", "box2d").own, 0);
}

TEST(Regimes, TheCourseStopsWhereTheWatchSays) {
    EXPECT_THROW(static_cast<void>(measure(
                     falling(), kinds(), {.repeats = 1, .watch = [](double) { throw Failure("stopped"); }})),
                 Failure);
}

TEST(Regimes, AKindThatCannotRunTheCourseSaysWhyAndTheOthersGoOn) {
    // The reference refuses a smooth pyramid, which slides apart.
    Scene scene = empty_scene({0, -9.81});
    add_ball(scene, {-0.1, 0.1});
    add_ball(scene, {0.1, 0.1});
    add_ball(scene, {0, 0.1 + 0.1 * std::sqrt(3.0)});
    add_part(scene, segment({-5, 0}, {5, 0}));
    const auto shared = std::make_shared<const Scene>(scene);
    const Course course{
        2, [shared] { return std::vector<std::shared_ptr<const Scene>>{shared}; }, {{"stacked", 0, 0.5}}};
    const std::vector<Kind> two{{"exact", "reference", {}}, {"box2d", "box2d", {}}};
    const auto results = measure(course, two, {.repeats = 2});
    EXPECT_NE(results[0].failure, "");
    EXPECT_TRUE(results[0].nanoseconds.empty());
    EXPECT_EQ(results[1].failure, "");
    EXPECT_EQ(results[1].nanoseconds.size(), 2U);
    EXPECT_FALSE(results[1].error.has_value());
}

}  // namespace
}  // namespace flipside::lab::regimes

#include "lab/contenders/recommended.hpp"

#include <gtest/gtest.h>

#include "lab/contenders/contender.hpp"
#include "lab/contenders/engines.hpp"
#include "lab/recommending.hpp"
#include "world/input_error.hpp"

namespace flipside::lab {
namespace {

TEST(KnownEngines, MayBeRecommendedSettings) {
    EXPECT_NO_THROW(require_known_engines(
        recommending(R"({"custom": {"sleep": "on"}, "box2d": {}, "reference": {}, "run": {"dt": 0.01}})")));
}

TEST(KnownEngines, AllOthersAreRefused) {
    const Scene scene = recommending(R"({"custm": {"motion_iterations": 9}})");
    try {
        require_known_engines(scene);
        FAIL() << "it was taken";
    } catch (const InputError& error) {
        EXPECT_STREQ(error.what(),
                     "my.json: /recommend/custm: \"custm\" is no engine; allowed: \"run\", \"custom\", "
                     "\"box2d\", \"reference\"");
    }
    EXPECT_THROW(
        static_cast<void>(contender_for(plain_contender(engine_named("custom")), scene, default_step)),
        InputError);
}

}  // namespace
}  // namespace flipside::lab

#include <limits>

#include <gtest/gtest.h>

#include "fake_world.hpp"
#include "lab/process/failure.hpp"
#include "lab/session/run.hpp"

namespace flipside::lab {
namespace {

/// A world that breaks: ball 1's spin is no number from 0.3 s on.
class Breaking final : public test::FakeWorld {
  public:
    using FakeWorld::FakeWorld;

    void step(double dt) override {
        FakeWorld::step(dt);
        if (time_ > 0.299) balls_[1].spin = std::numeric_limits<double>::quiet_NaN();
    }
};

TEST(Run, StopsAtTheFirstNumberThatIsNone) {
    const Engine breaking{"breaking", "", {}, [](std::shared_ptr<const Scene> scene, const Settings&) {
                              const std::shared_ptr<const Scene> held = std::move(scene);
                              return std::unique_ptr<World>(std::make_unique<Breaking>(held->balls));
                          }};
    Scene scene;
    scene.balls.resize(2);
    scene.balls[1].number = 1;
    Session session(std::make_shared<const Scene>(scene), breaking, Settings({}));
    int steps = 0;
    try {
        run({&session, 1}, Timeline(0, 1, 0.1), {}, [&](const Session&, std::uint64_t, double) { ++steps; });
        FAIL() << "it went on";
    } catch (const Failure& failure) {
        EXPECT_STREQ(failure.what(), "ball 1 is not a number any more at 0.300000 s (engine breaking)");
    }
    EXPECT_EQ(steps, 2);
}

}  // namespace
}  // namespace flipside::lab

#include "box2d/misfit.hpp"

#include <gtest/gtest.h>

#include "box2d/engine.hpp"
#include "world/input_error.hpp"
#include "world/refusal.hpp"
#include "world/scene_file.hpp"

namespace flipside::box2d {
namespace {

Ball pinball() {
    Ball ball;
    ball.radius = 0.0135;
    ball.mass = 0.08;
    return ball;
}

TEST(Misfit, IsWhatSinglePrecisionCannotHold) {
    const Units units{{1, 0}, 40};
    EXPECT_FALSE(misfit(pinball(), units));
    const auto expect = [&](const char* key, const std::string& says, const auto& change) {
        Ball ball = pinball();
        change(ball);
        const auto found = misfit(ball, units);
        ASSERT_TRUE(found) << key;
        EXPECT_STREQ(found->key, key);
        EXPECT_TRUE(found->problem.starts_with(says)) << found->problem;
    };
    expect("mass", "is 1e+29 kg; box2d", [](Ball& ball) { ball.mass = 1e29; });
    expect("mass", "is 1e-29 kg", [](Ball& ball) { ball.mass = 1e-29; });
    expect("radius", "is 1e+14 m;", [](Ball& ball) { ball.radius = 1e14; });
    expect("radius", "is 1e-60 m;", [](Ball& ball) { ball.radius = 1e-60; });
    expect("position", "is 1e+20 m from the middle", [](Ball& ball) { ball.position = {0, 1e20}; });
    expect("velocity", "is 1e+20 m/s", [](Ball& ball) { ball.velocity = {-1e20, 0}; });
    expect("angle", "is -1e+20 rad", [](Ball& ball) { ball.angle = -1e20; });
    expect("spin", "is 1e+20 rad/s", [](Ball& ball) { ball.spin = 1e20; });
}

std::string scene_text(const std::string& keys) {
    return R"({"format": "flipside-scene/1", "name": "scene", "gravity": [0, 0], "parts": [], )" + keys + "}";
}
constexpr const char* bounds = R"("bounds": {"min": [-1, -1], "max": [1, 1]}, )";

std::unique_ptr<World> make(const std::string& keys) {
    auto scene = std::make_shared<const Scene>(parse_scene(scene_text(keys), "scene.json"));
    return engine().make(std::move(scene), Settings(engine().settings));
}

std::string refusal_of(const std::string& keys) {
    try {
        static_cast<void>(make(keys));
        return "none";
    } catch (const InputError& error) {
        return error.what();
    }
}

TEST(Misfit, IsNamedByItsPlaceInTheSceneFile) {
    const std::string error =
        refusal_of(std::string(bounds) + R"("balls": [{"position": [0, 0], "radius": 0.1, "mass": 1},
                                                      {"position": [0, 0.5], "radius": 0.1, "mass": 1e29}])");
    EXPECT_TRUE(error.starts_with("scene.json: /balls/1/mass: is 1e+29 kg; box2d ")) << error;
}

TEST(Misfit, ThatIsGeneratedIsNamedByItsNumber) {
    const std::string error = refusal_of(std::string(bounds) + R"("balls": [], "generate": [
        {"type": "rows", "of": "balls", "from": [0, 0], "step": [0.5, 0.5], "count": 2,
         "radius": 0.1, "mass": 1e29}])");
    EXPECT_TRUE(error.starts_with("scene.json: /generate: the mass of ball 0 is 1e+29 kg; box2d ")) << error;
}

TEST(Misfit, ThatIsLaunchedEndsTheStepNotTheProgram) {
    const auto world = make(std::string(bounds) + R"("balls": [], "launcher": {"position": [0, 0],
        "direction_deg": 90, "speed": [1, 1], "ball": {"radius": 0.1, "mass": 1e29}})");
    world->step(0.01);
    world->apply(control::Launch{1, 1, 1});
    EXPECT_THROW(world->step(0.01), Refusal);
    EXPECT_EQ(world->time(), 0.01);
    EXPECT_TRUE(world->balls().empty());
}

TEST(Misfit, OfAStateIsNamedByItsPlaceThere) {
    const auto world = make(std::string(bounds) + R"("balls": [{"position": [0, 0], "radius": 0.1, "mass": 1},
                                                      {"position": [0, 0.5], "radius": 0.1, "mass": 1}])");
    State state = world->save();
    state.balls[1].spin = 1e20;
    try {
        world->restore(state);
        FAIL() << "restored";
    } catch (const InputError& error) {
        EXPECT_TRUE(std::string(error.what()).starts_with("/balls/1/spin: is 1e+20 rad/s; ")) << error.what();
    }
}

}  // namespace
}  // namespace flipside::box2d

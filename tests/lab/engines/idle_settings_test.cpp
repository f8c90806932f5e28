/// What an engine says of its settings: those that are said to change nothing change nothing.

#include <gtest/gtest.h>

#include "lab/engines/every_solver.hpp"
#include "lab/files/assets.hpp"
#include "lab/session/session.hpp"
#include "world/scene_file.hpp"

namespace flipside::lab {
namespace {

/// Of all balls, after two launches, some seconds and a nudge.
std::vector<double> outcome(const Engine& engine, const Settings& settings) {
    static const auto scene = std::make_shared<const Scene>(load_scene(scene_file("pinball")));
    Session session(scene, engine, settings);
    session.apply(control::Launch{0.8, 2, 1});
    for (int i = 0; i < 150; ++i) session.step(1.0 / 60);
    session.apply(control::Nudge{{0.2, 0.1}});
    for (int i = 0; i < 30; ++i) session.step(1.0 / 60);
    std::vector<double> numbers;
    for (const Ball& ball : session.world().balls())
        for (const double number : {ball.position.x, ball.position.y, ball.velocity.x, ball.velocity.y})
            numbers.push_back(number);
    return numbers;
}

/// The values at both ends.
std::pair<double, double> ends(const SettingSpec& spec) {
    if (spec.type == SettingType::toggle) return {0, 1};
    if (spec.type == SettingType::choice) return {0, static_cast<double>(spec.choices.size() - 1)};
    return {spec.min, spec.max};
}

TEST(IdleSettings, ChangeNothing) {
    int idle = 0;
    for (const auto& [engine, settings] : every_solver())
        for (const SettingSpec& spec : settings.specs()) {
            if (settings.idle(spec.name).empty()) continue;
            ++idle;
            SCOPED_TRACE(std::string(engine->name) + '.' + std::string(spec.name));
            Settings least = settings, most = settings;
            least.set(spec.name, ends(spec).first);
            most.set(spec.name, ends(spec).second);
            const auto expected = outcome(*engine, least);
            EXPECT_FALSE(expected.empty());
            EXPECT_EQ(expected, outcome(*engine, most));
        }
    EXPECT_GT(idle, 5);
}

TEST(IdleSettings, NameSettingsAndValuesThatThereAre) {
    for (const Engine* engine : engines())
        for (const SettingSpec& spec : engine->settings)
            for (const std::string_view value : spec.acts_with.values) {
                Settings settings(engine->settings);
                EXPECT_NO_THROW(settings.set(spec.acts_with.setting, value)) << spec.name;
                EXPECT_NE(spec.acts_with.setting, spec.name);
            }
}

}  // namespace
}  // namespace flipside::lab

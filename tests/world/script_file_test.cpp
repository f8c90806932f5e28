#include "world/script_file.hpp"

#include "world/support.hpp"

namespace flipside {
namespace {

std::string script(const std::string& controls) {
    return R"({"format": "flipside-script/1", "controls": [)" + controls + "]}";
}

TEST(ScriptFile, EveryControlIsReadWithItsDefaults) {
    const Scene scene = scene_with_everything();
    const Script s = parse_script(script(R"(
        {"time": 0, "control": "launch"},
        {"time": 0.5, "control": "launch", "strength": 0.25, "count": 7, "size": 2},
        {"time": 0.5, "control": "flip", "side": "right", "up": true},
        {"time": 1, "control": "nudge", "velocity": [0.1, -0.2]},
        {"time": 2, "control": "rotate", "on": true},
        {"time": 3, "control": "raise_targets"},
        {"time": 3, "control": "raise_targets", "parts": ["drop 2", "drop 1"]})"),
                                  "s.json", scene);
    ASSERT_EQ(s.size(), 7U);
    EXPECT_EQ(std::get<control::Launch>(s[0].control).strength, 1);
    EXPECT_EQ(std::get<control::Launch>(s[0].control).count, 1);
    EXPECT_EQ(std::get<control::Launch>(s[0].control).size, 1);
    EXPECT_EQ(s[1].time, 0.5);
    EXPECT_EQ(std::get<control::Launch>(s[1].control).strength, 0.25);
    EXPECT_EQ(std::get<control::Launch>(s[1].control).count, 7);
    EXPECT_EQ(std::get<control::Launch>(s[1].control).size, 2);
    EXPECT_EQ(std::get<control::Flip>(s[2].control).side, Side::right);
    EXPECT_TRUE(std::get<control::Flip>(s[2].control).up);
    EXPECT_EQ(std::get<control::Nudge>(s[3].control).velocity, (Vec2{0.1, -0.2}));
    EXPECT_TRUE(std::get<control::Rotate>(s[4].control).on);
    EXPECT_TRUE(std::get<control::RaiseTargets>(s[5].control).parts.empty());
    EXPECT_EQ(std::get<control::RaiseTargets>(s[6].control).parts, (std::vector<PartIndex>{5, 4}));
}

TEST(ScriptFile, WhatIsWrittenReadsBackTheSame) {
    const Scene scene = scene_with_everything();
    const Script before = {{1.0 / 3, control::Launch{0.1, 3, 1.5}},
                           {0.7, control::Flip{Side::left, true}},
                           {0.7, control::Nudge{{-1e-7, 2.0 / 3}}},
                           {1e6 / 7, control::Rotate{true}},
                           {1e6, control::RaiseTargets{{4}}}};
    const std::string text = to_json(before, scene);
    const Script after = parse_script(text, "s.json", scene);
    ASSERT_EQ(after.size(), before.size());
    for (std::size_t i = 0; i < before.size(); ++i) EXPECT_EQ(after[i].time, before[i].time);
    EXPECT_EQ(std::get<control::Nudge>(after[2].control).velocity, (Vec2{-1e-7, 2.0 / 3}));
    EXPECT_EQ(to_json(after, scene), text);
}

TEST(ScriptFile, BadOnesAreRefusedWithTheirPlace) {
    struct Bad {
        std::string text, start, says;
    };
    const std::string flip = R"({"time": 1, "control": "flip", "side": "left", "up": true})";
    const Bad all[] = {
        {"", "s.json: ", "empty"},
        {"[]", "s.json: is an array", "allowed: an object"},
        {R"({"controls": []})", "s.json: ", "\"format\" is missing"},
        {R"({"format": "flipside-scene/1", "controls": []})", "s.json: /format: ", "flipside-script/1"},
        {R"({"format": "flipside-script/1"})", "s.json: ", "\"controls\" is missing"},
        {script("1"), "s.json: /controls/0: ", "is 1"},
        {script(R"({"control": "launch"})"), "s.json: /controls/0: ", "\"time\" is missing"},
        {script(R"({"time": 1})"), "s.json: /controls/0: ", "it takes launch, flip, nudge"},
        {script(R"({"time": 1, "control": "jump"})"), "s.json: /controls/0/control: ", "is \"jump\""},
        {script(R"({"time": -1, "control": "launch"})"), "s.json: /controls/0/time: ", "from 0"},
        {script(R"({"time": 1e999, "control": "launch"})"), "s.json: /controls/0/time: ", "range"},
        {script(flip + R"(, {"time": 0.5, "control": "launch"})"), "s.json: /controls/1/time: ", "in order"},
        {script(R"({"time": 1, "control": "launch", "strength": 1.1})"),
         "s.json: /controls/0/strength: ", "from 0 to 1"},
        {script(R"({"time": 1, "control": "launch", "count": 0})"), "s.json: /controls/0/count: ", "from 1"},
        {script(R"({"time": 1, "control": "launch", "count": 1.5})"), "s.json: /controls/0/count: ", "whole"},
        {script(R"({"time": 1, "control": "launch", "size": 0})"), "s.json: /controls/0/size: ", "is 0"},
        {script(R"({"time": 1, "control": "launch", "up": true})"),
         "s.json: /controls/0/up: ", "unknown key"},
        {script(R"({"time": 1, "control": "flip", "side": "up", "up": true})"),
         "s.json: /controls/0/side: ", "left, right"},
        {script(R"({"time": 1, "control": "flip", "side": "left"})"),
         "s.json: /controls/0: ", "\"up\" is missing; it takes true or false"},
        {script(R"({"time": 1, "control": "nudge", "velocity": 3})"),
         "s.json: /controls/0/velocity: ", "exactly 2"},
        {script(R"({"time": 1, "control": "rotate", "on": 1})"), "s.json: /controls/0/on: ", "true or false"},
        {script(R"({"time": 1, "control": "raise_targets", "parts": ["wall"]})"),
         "s.json: /controls/0/parts/0: ", "no drop target of this scene; allowed: \"drop 1\", \"drop 2\""},
        {script(R"({"time": 1, "control": "raise_targets", "parts": []})"),
         "s.json: /controls/0/parts: ", "from 1"},
    };
    const Scene scene = scene_with_everything();
    for (const Bad& bad : all)
        expect_error(error_of([&] { (void)parse_script(bad.text, "s.json", scene); }), bad.start, bad.says);
    Scene no_launcher = scene;
    no_launcher.launcher.reset();
    expect_error(error_of([&] {
                     (void)parse_script(script(R"({"time": 1, "control": "launch"})"), "s.json", no_launcher);
                 }),
                 "s.json: /controls/0/control: ", "no launcher");
}

}  // namespace
}  // namespace flipside

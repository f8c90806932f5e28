/// Replays from elsewhere: what is damaged is refused with its place and reason.

#include <functional>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "lab/contenders/engines.hpp"
#include "lab/files/assets.hpp"
#include "lab/replay/play.hpp"
#include "world/input_error.hpp"
#include "world/scene_file.hpp"

namespace flipside::lab {
namespace {

using Json = nlohmann::json;

/// A second of pinball with a move of most kinds.
Json short_game() {
    const auto scene = std::make_shared<const Scene>(load_scene(scene_file("pinball")));
    const Engine& custom = engine_named("custom");
    Session game(scene, custom, settings_for(custom, *scene));
    game.apply(control::Launch{0.9});
    for (int k = 0; k < 60; ++k) {
        if (k == 20) game.apply(control::Flip{Side::left, true});
        if (k == 30) game.change(scene, engine_named("box2d"), settings_for(engine_named("box2d"), *scene));
        game.step(k < 40 ? 1.0 / 60 : 1.0 / 120);
    }
    const RecordedRun run{"game", &game, 1.0 / 60};
    return Json::parse(to_json(replay_of({&run, 1})));
}

std::string refusal_of(const std::string& text) {
    try {
        static_cast<void>(parse_replay(text, "r"));
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

TEST(ReplayFile, WhatIsWrittenReadsBackTheSame) {
    const Json game = short_game();
    const Replay read = parse_replay(game.dump(), "r");
    EXPECT_EQ(Json::parse(to_json(read)), game);
    ASSERT_EQ(read.runs.size(), 1U);
    ASSERT_EQ(read.runs[0].moves.size(), 4U);
    EXPECT_EQ(read.runs[0].moves[1].step, 20U);
    EXPECT_EQ(std::get<move::Change>(read.runs[0].moves[2].move).engine->name, "box2d");
    EXPECT_EQ(std::get<move::StepLength>(read.runs[0].moves[3].move).dt, 1.0 / 120);
}

TEST(ReplayFile, TheSceneIsTheOneOfTheFileToTheBit) {
    const auto file = load_scene(scene_file("pinball"));
    const Replay read = parse_replay(short_game().dump(), "r");
    ASSERT_EQ(read.scene->parts.size(), file.parts.size());
    int flippers = 0;
    for (std::size_t i = 0; i < file.parts.size(); ++i) {
        const auto* flipper = std::get_if<shape::Flipper>(&file.parts[i].shape.is);
        if (flipper == nullptr) continue;
        EXPECT_EQ(std::get<shape::Flipper>(read.scene->parts[i].shape.is).rest, flipper->rest);
        ++flippers;
    }
    EXPECT_GT(flippers, 0);
}

TEST(ReplayFile, EveryDamageIsRefusedWithItsPlaceAndReason) {
    const Json good = short_game();
    ASSERT_EQ(refusal_of(good.dump()), "");
    struct Damage {
        std::function<void(Json&)> make;
        std::string start, says;
    };
    const std::string run = "r: /runs/0";
    const Damage all[] = {
        {[](Json& j) { j = Json::array(); }, "r: ", "allowed: an object"},
        {[](Json& j) { j["format"] = "flipside-replay/9"; }, "r: /format", "flipside-replay/1"},
        {[](Json& j) { j.erase("scene"); }, "r: ", "\"scene\" is missing"},
        {[](Json& j) { j["more"] = 1; }, "r: /more", "unknown key"},
        {[](Json& j) { j["runs"] = Json::array(); }, "r: /runs", "from 1 to 4 long"},
        {[](Json& j) { j["runs"].push_back(j["runs"][0]); }, "r: /runs/1/name", "there twice"},
        {[](Json& j) { j["scene"]["parts"] = 3; }, "r: /scene/parts", "an array"},
        {[](Json& j) { j["scene"]["parts"][0]["material"] = "cheese"; }, "r: /scene/parts/0", "cheese"},
        {[](Json& j) {
             j["scene"]["gravity"] = {0, 1e300};
         },
         "r: /scene/gravity/1", "to"},
        {[](Json& j) { j["runs"][0]["name"] = "../../x"; }, run + "/name", "no name"},
        {[](Json& j) { j["runs"][0]["engine"] = "/tmp/evil.so"; }, run + "/engine", "not built in"},
        {[](Json& j) { j["runs"][0]["settings"]["cheese"] = "1"; }, run + "/settings/cheese", "cheese"},
        {[](Json& j) { j["runs"][0]["settings"]["solver"] = "x"; }, run + "/settings/solver", "simple"},
        {[](Json& j) { j["runs"][0]["dt"] = 0; }, run + "/dt", "from 1e-15 to 1"},
        {[](Json& j) { j["runs"][0]["dt"] = "fast"; }, run + "/dt", "a number"},
        {[](Json& j) { j["runs"][0]["steps"] = -1; }, run + "/steps", "from 0 to 10000000"},
        {[](Json& j) { j["runs"][0]["steps"] = 1e18; }, run + "/steps", "from 0 to 10000000"},
        {[](Json& j) { j["runs"][0]["steps"] = 6000; }, run + "/checks", "here 10"},
        {[](Json& j) { j["runs"][0]["steps"] = 25; }, run + "/moves/2/step", "up to the 25 steps"},
        {[](Json& j) { j["runs"][0]["moves"][1]["step"] = 35; }, run + "/moves/2/step", "in order"},
        {[](Json& j) { j["runs"][0]["moves"][0]["move"] = "explode"; }, run + "/moves/0/move",
         "launch, flip"},
        {[](Json& j) { j["runs"][0]["moves"][0]["strength"] = 2; }, run + "/moves/0/strength", "from 0 to 1"},
        {[](Json& j) { j["runs"][0]["moves"][0]["count"] = 100000; }, run + "/moves/0/count", "to 1000"},
        {[](Json& j) { j["runs"][0]["moves"][0]["more"] = 1; }, run + "/moves/0/more", "unknown key"},
        {[](Json& j) { j["runs"][0]["moves"][1].erase("side"); }, run + "/moves/1", "\"side\" is missing"},
        {[](Json& j) { j["runs"][0]["moves"][2]["engine"] = "./x"; }, run + "/moves/2/engine",
         "not built in"},
        {[](Json& j) { j["runs"][0]["moves"][3]["dt"] = 1e9; }, run + "/moves/3/dt", "to 1"},
        {[](Json& j) {
             j["runs"][0]["moves"].push_back({{"step", 60}, {"move", "add"}, {"ball", 7}});
         },
         run + "/moves/4/ball", "an object"},
        {[](Json& j) { j["runs"][0]["end"]["checksum"] = "0123456789abcdeg"; }, run + "/end/checksum",
         "hexadecimal"},
        {[](Json& j) { j["runs"][0]["end"]["checksum"] = "12"; }, run + "/end/checksum", "from 16 to 16"},
        {[](Json& j) {
             j["runs"][0]["script"] = {{"format", "flipside-script/1"}, {"controls", 1}};
         },
         run + "/script/controls", "an array"},
    };
    for (const Damage& damage : all) {
        Json bad = good;
        damage.make(bad);
        const std::string refusal = refusal_of(bad.dump());
        EXPECT_TRUE(refusal.starts_with(damage.start)) << damage.start << " expected, got " << refusal;
        EXPECT_NE(refusal.find(damage.says), std::string::npos)
            << damage.says << " expected, got " << refusal;
    }
}

TEST(ReplayFile, WhatIsNoJsonIsRefused) {
    const std::string good = short_game().dump();
    for (const std::size_t length : {std::size_t{0}, std::size_t{1}, good.size() / 2, good.size() - 1})
        EXPECT_NE(refusal_of(good.substr(0, length)).find("not JSON"), std::string::npos) << length;
    EXPECT_NE(refusal_of(std::string(100'000, '[')).find("nested too deep"), std::string::npos);
    EXPECT_NE(refusal_of(R"({"format": 1e999})").find("beyond the range"), std::string::npos);
    EXPECT_NE(refusal_of(R"({"format": 1, "format": 1})").find("twice"), std::string::npos);
}

TEST(ReplayFile, NoCutOfItPasses) {
    const std::string good = short_game().dump();
    for (std::size_t length = 0; length < good.size(); length += 211)
        EXPECT_NE(refusal_of(good.substr(0, length)), "") << length;
}

}  // namespace
}  // namespace flipside::lab

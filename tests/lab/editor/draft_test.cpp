#include "lab/editor/draft.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "lab/files/assets.hpp"
#include "lab/session/pick.hpp"
#include "world/input_error.hpp"
#include "world/json_file.hpp"
#include "world/scene_file.hpp"

namespace flipside::lab {
namespace {

using Kind = Item::Kind;

std::string text_of(const std::string& scene) {
    return read_file(scene_file(scene));
}

const Tool& tool_named(std::string_view name) {
    for (const Tool& tool : tools())
        if (tool.name == name) return tool;
    throw std::runtime_error("no such tool");
}

TEST(Draft, IsEveryShippedSceneAsItIs) {
    for (const std::string& name : scene_names()) {
        const Draft draft(text_of(name), name);
        EXPECT_EQ(draft.document().text(), text_of(name));
        EXPECT_FALSE(draft.problem()) << name;
        EXPECT_LE(draft.sketch().parts.size(), draft.scene()->parts.size());
    }
    EXPECT_THROW(Draft("{}", "bad"), InputError);
}

TEST(Draft, SaysWhoseFaultItIsInTheWordsOfTheCheck) {
    Draft draft(text_of("pinball"), "pinball");
    draft.set({"parts", "3", "name"}, draft.sketch().parts[2].name);
    ASSERT_TRUE(draft.problem());
    EXPECT_EQ(draft.problem()->item, (Item{Kind::part, 3}));
    try {
        static_cast<void>(parse_scene(draft.document().text(), "file"));
        FAIL();
    } catch (const InputError& error) {
        EXPECT_EQ(error.what(), "file: /parts/3: " + draft.problem()->words);
    }
    draft.revert_step();
    EXPECT_FALSE(draft.problem());
}

TEST(Draft, ABallThatIsOutsideIsBallNumberSoMuch) {
    Draft draft(new_scene(), "new");
    const Vec2 inside[] = {{0.1, 0.1}}, outside[] = {{-5, 0}};
    draft.add(tool_named("Ball"), inside);
    EXPECT_FALSE(draft.problem());
    draft.add(tool_named("Ball"), outside);
    ASSERT_TRUE(draft.problem());
    EXPECT_EQ(draft.problem()->item, (Item{Kind::ball, 1}));
}

TEST(Draft, RulesFollowNamesAndWhatIsRemoved) {
    Draft draft(text_of("pinball"), "pinball");
    const auto index = [&](const std::string& name) {
        const auto& parts = draft.sketch().parts;
        return static_cast<std::size_t>(std::ranges::find(parts, name, &Part::name) - parts.begin());
    };
    const std::size_t rules = draft.scene()->rules->scores.size();
    draft.rename(index("target-left-a"), "first");
    ASSERT_FALSE(draft.problem());
    EXPECT_EQ(draft.scene()->parts[draft.scene()->rules->targets[0].parts[0]].name, "first");
    EXPECT_EQ(draft.scene()->rules->scores.size(), rules);
    for (const char* name : {"lane-a", "lane-b", "lane-c", "spinner-left"})
        draft.remove({Kind::part, index(name)});
    ASSERT_FALSE(draft.problem());
    EXPECT_TRUE(draft.scene()->rules->lanes.empty());
    EXPECT_EQ(draft.scene()->rules->spinners.size(), 1U);
    draft.revert_step();
    EXPECT_EQ(draft.document().text(), text_of("pinball"));
}

TEST(Draft, OneWallMovedChangesItsNumbersAlone) {
    Draft draft(text_of("toy"), "toy");
    const Item floor{Kind::part, 0};
    draft.replace(floor, moved(*draft.find(floor), {0.001, 0}));
    std::string wanted = text_of("toy");
    const std::string before = R"("a": [0.032, 0.032], "b": [0.992, 0.032])";
    wanted.replace(wanted.find(before), before.size(), R"("a": [0.033, 0.032], "b": [0.993, 0.032])");
    EXPECT_EQ(draft.document().text(), wanted);
    EXPECT_FALSE(draft.problem());
}

TEST(Draft, ACopyHasAFreeNameAndAMaterialOfItsOwn) {
    Draft draft(new_scene(), "new");
    const Vec2 ends[] = {{0.1, 0.1}, {0.2, 0.1}};
    const Item wall = draft.add(tool_named("Wall"), ends);
    EXPECT_EQ(draft.find(wall)->at("name"), "wall-1");
    const Item copy = draft.duplicate(wall, {0, 0.1});
    EXPECT_EQ(draft.find(copy)->at("name"), "wall-2");
    draft.add_material(path_of(copy), "wall");
    EXPECT_EQ(draft.find(copy)->at("material"), "material-1");
    EXPECT_EQ(find(draft.document().json(), {"materials", "material-1"})->at("restitution"), 0.6);
    EXPECT_FALSE(draft.problem());
}

TEST(Draft, ASceneHasOneLauncher) {
    Draft draft(text_of("pinball"), "pinball");
    const Vec2 place[] = {{0.4, 0.2}};
    draft.add(tool_named("Launcher"), place);
    EXPECT_EQ(draft.scene()->launcher->position, place[0]);
    EXPECT_TRUE(draft.scene()->launcher->plunger);
    EXPECT_EQ(draft.scene()->launcher->fastest, 3);
}

/// Something that a hand may do.
void do_something(Draft& draft) {
    const auto place = [] {
        return Vec2{*rc::gen::inRange(0, 520) * 1e-3, *rc::gen::inRange(0, 1070) * 1e-3};
    };
    const Scene& scene = draft.sketch();
    std::vector<Item> items{{Kind::bounds, 0}};
    for (std::size_t i = 0; i < scene.parts.size(); ++i) items.push_back({Kind::part, i});
    for (std::size_t i = 0; i < scene.balls.size(); ++i) items.push_back({Kind::ball, i});
    if (scene.launcher) items.push_back({Kind::launcher, 0});
    const Item item = *rc::gen::elementOf(items);
    const OrderedJson* thing = draft.find(item);
    switch (*rc::gen::inRange(0, 8)) {
        case 0: {
            const Tool& tool = tools()[static_cast<std::size_t>(*rc::gen::inRange(1, int(tools().size())))];
            std::vector<Vec2> points;
            for (int i = tool.points == 0 ? 3 : tool.points; i > 0; --i) points.push_back(place());
            draft.add(tool, points);
            break;
        }
        case 1:
            draft.remove(item);
            break;
        case 2:
            if (thing && item.kind != Kind::launcher && item.kind != Kind::bounds)
                draft.duplicate(item, place());
            break;
        case 3:
            if (item.kind == Kind::part)
                draft.rename(item.index, *rc::gen::elementOf(std::vector<std::string>{"a", "b", "c,"}));
            break;
        case 4:
            if (thing) draft.replace(item, turned(*thing, place(), *rc::gen::inRange(-9, 9) * 0.3));
            break;
        case 5:
            if (item.kind == Kind::part || item.kind == Kind::ball) draft.add_material(path_of(item), "wall");
            break;
        default:
            if (thing && item.kind != Kind::bounds)
                draft.replace(item, pulled(*thing, *rc::gen::elementOf(handles_of(*thing)), place()));
    }
}

RC_GTEST_PROP(DraftProperty, WhateverIsDrawnIsUndoneToTheByteAndSeenAsItIsRun, ()) {
    const std::string name = *rc::gen::element<std::string>("pinball", "toy", "cradle", "");
    const std::string before = name.empty() ? new_scene() : text_of(name);
    Draft draft(before, name);
    for (int i = *rc::gen::inRange(1, 10); i > 0; --i) {
        do_something(draft);
        draft.end_step();
        // What the check says is what `flipside check` says, and a good one is drawn as it is run.
        std::string problem;
        try {
            const Scene good = parse_scene(draft.document().text(), "scene");
            RC_ASSERT(good.parts.size() >= draft.sketch().parts.size());
            for (std::size_t p = 0; p < draft.sketch().parts.size(); ++p) {
                RC_ASSERT(good.parts[p].name == draft.sketch().parts[p].name);
                RC_ASSERT(good.materials[good.parts[p].material].kick ==
                          draft.sketch().materials[draft.sketch().parts[p].material].kick);
            }
        } catch (const InputError& error) {
            problem = error.what();
        }
        RC_ASSERT(draft.problem().has_value() == !problem.empty());
        RC_ASSERT(
            (problem.empty() || problem.ends_with(draft.problem()->words)));  // in brackets, so that || stops
        // Its form stays that of the schema: only the meaning of what a hand draws can be at fault.
        RC_ASSERT(problem.find("schema") == std::string::npos);
    }
    const std::string after = draft.document().text();
    while (draft.undo()) continue;
    RC_ASSERT(draft.document().text() == before);
    RC_ASSERT(!draft.problem());
    while (draft.redo()) continue;
    RC_ASSERT(draft.document().text() == after);
}

RC_GTEST_PROP(DraftProperty, WhatIsPointedAtIsHit, ()) {
    // On an empty table, any point of what is drawn is a point of it, and what is far from all is of nothing.
    Draft draft(new_scene(), "new");
    const Tool& tool = tool_named(
        *rc::gen::element<std::string>("Wall", "Arc", "Circle", "Capsule", "Gate", "Flipper", "Walls"));
    const auto place = [] {
        return Vec2{*rc::gen::inRange(100, 420) * 1e-3, *rc::gen::inRange(100, 900) * 1e-3};
    };
    const Vec2 points[] = {place(), place()};
    RC_PRE(length(points[1] - points[0]) > 0.03);
    const Item item = draft.add(tool, points);
    const Scene& scene = draft.sketch();
    const std::vector<PartState> still(scene.parts.size());
    constexpr double reach = 0.002;
    for (const Vec2 joint : joints_of(*draft.find(item)))
        RC_ASSERT(pick(scene, {}, still, joint + Vec2{0.5 * reach, 0}, reach) == Other::part(0));
    const Box box = extent_of(scene, still, 0);
    RC_ASSERT(!pick(scene, {}, still, box.max + Vec2{2 * reach, 0}, reach));
    RC_ASSERT(!pick(scene, {}, still, box.min - Vec2{0, 2 * reach}, reach));
}

}  // namespace
}  // namespace flipside::lab

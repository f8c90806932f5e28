#include "lab/conformance/conformance.hpp"

#include <algorithm>
#include <fstream>
#include <sstream>

#include "places.hpp"
#include "support.hpp"
#include "world/input_error.hpp"
#include "world/schema.hpp"

namespace flipside::plugin {
namespace {

using lab::Conformance;
using lab::Grade;

/// It stays where it is: what checks by it remembers it.
const std::string& schema() {
    static const std::string text = [] {
        std::ostringstream words;
        words << std::ifstream(test::source("assets/conformance.schema.json")).rdbuf();
        return words.str();
    }();
    return text;
}

/// Checks what holds of all marks.
Conformance marks_of(const char* file) {
    Conformance conformance = lab::check_conformance(file);
    EXPECT_EQ(conformance.of(), 100);
    check_form(parse_json(to_json(conformance), "marks"), schema(), "marks");
    for (const lab::Mark& mark : conformance.marks) {
        EXPECT_LE(mark.points, mark.of) << mark.name;
        EXPECT_EQ(mark.grade == Grade::pass, mark.points == mark.of) << mark.name;
        EXPECT_TRUE(mark.grade != Grade::not_offered || !mark.mandatory) << mark.name;
    }
    return conformance;
}

std::vector<std::string> names(const Conformance& conformance, Grade grade) {
    std::vector<std::string> found;
    for (const lab::Mark& mark : conformance.marks)
        if (mark.grade == grade) found.push_back(mark.name);
    return found;
}

using Names = std::vector<std::string>;

TEST(PluginConformance, TheExampleInCPassesAndWhatItLacksIsNamed) {
    const Conformance marks = marks_of(test::engine_in_c);
    EXPECT_TRUE(marks.passed());
    EXPECT_EQ(marks.engine, "engine-in-c");
    EXPECT_EQ(names(marks, Grade::not_offered), (Names{"arcs", "polygons", "capsules", "friction", "damping",
                                                       "moving parts", "sensors", "layers", "gates"}));
    EXPECT_EQ(names(marks, Grade::part), (Names{"controls"}));
}

#ifdef FLIPSIDE_WITH_CHIPMUNK
TEST(PluginConformance, ChipmunkPassesAndFliesNoExactParabola) {
    const Conformance marks = marks_of(test::chipmunk_engine);
    EXPECT_TRUE(marks.passed()) << to_json(marks);
    EXPECT_EQ(marks.library, "Chipmunk 7.0.3");
    EXPECT_EQ(names(marks, Grade::not_offered), Names{});
    EXPECT_EQ(names(marks, Grade::part), (Names{"free fall"}));
}
#endif

TEST(PluginConformance, WhatIsDeclaredAndWrongFails) {
    // It declares everything, and its balls fall through everything.
    const Conformance marks = marks_of(test::naughty_engine);
    EXPECT_FALSE(marks.passed());
    const Names failed = names(marks, Grade::fail);
    for (const char* name : {"bounce", "momentum", "segments", "gates", "sensors"})
        EXPECT_NE(std::ranges::find(failed, name), failed.end()) << name;
    for (const char* name : {"free fall", "steps", "determinism", "ball numbers"})
        EXPECT_EQ(std::ranges::find(failed, name), failed.end()) << name;
}

TEST(PluginConformance, WhatCannotBeLoadedFailsEverywhereAndWhatIsNotThereIsBadInput) {
    const Conformance marks = marks_of(test::not_an_engine);
    EXPECT_FALSE(marks.passed());
    EXPECT_EQ(marks.points(), 0);
    EXPECT_THROW(static_cast<void>(lab::check_conformance("./nothing-there.so")), InputError);
}

}  // namespace
}  // namespace flipside::plugin

#include "world/settings.hpp"

#include <limits>

#include "world/support.hpp"

namespace flipside {
namespace {

constexpr std::string_view phases[] = {"brute", "quadtree"};
constexpr SettingSpec specs[] = {
    {.name = "slop",
     .type = SettingType::real,
     .unit = "m",
     .initial = 0.5,
     .min = 0,
     .max = 1,
     .choices = {},
     .about = ""},
    {.name = "iterations",
     .type = SettingType::integer,
     .unit = "",
     .initial = 4,
     .min = 1,
     .max = 64,
     .choices = {},
     .about = ""},
    {.name = "bullets",
     .type = SettingType::toggle,
     .unit = "",
     .initial = 1,
     .min = 0,
     .max = 1,
     .choices = {},
     .about = ""},
    {.name = "broad_phase",
     .type = SettingType::choice,
     .unit = "",
     .initial = 1,
     .min = 0,
     .max = 0,
     .choices = phases,
     .about = ""},
};

constexpr std::string_view solvers[] = {"simple", "exact"}, simple[] = {"simple"}, tree[] = {"quadtree"};
constexpr SettingSpec dependent_specs[] = {
    {.name = "solver", .type = SettingType::choice, .choices = solvers, .about = ""},
    {.name = "broad_phase",
     .type = SettingType::choice,
     .initial = 1,
     .choices = phases,
     .about = "",
     .acts_with = {"solver", simple}},
    {.name = "levels",
     .type = SettingType::integer,
     .initial = 4,
     .min = 1,
     .max = 8,
     .about = "",
     .acts_with = {"broad_phase", tree}},
};

TEST(Settings, SayWhyOneChangesNothing) {
    Settings s(dependent_specs);
    for (const char* name : {"solver", "broad_phase", "levels"}) EXPECT_EQ(s.idle(name), "");
    s.set("broad_phase", "brute");
    EXPECT_EQ(s.idle("levels"), "only with broad_phase quadtree");
    s.set("broad_phase", "quadtree");
    s.set("solver", "exact");
    EXPECT_EQ(s.idle("broad_phase"), "only with solver simple");
    EXPECT_EQ(s.idle("levels"), "only with solver simple");
}

TEST(Settings, StartAtTheirDefaults) {
    const Settings s(specs);
    EXPECT_EQ(s.real("slop"), 0.5);
    EXPECT_EQ(s.integer("iterations"), 4);
    EXPECT_TRUE(s.toggle("bullets"));
    EXPECT_EQ(s.choice("broad_phase"), "quadtree");
}

TEST(Settings, AreSetFromTextAndNumbers) {
    Settings s(specs);
    s.set("slop", "1e-3");
    s.set("iterations", "64");
    s.set("bullets", "off");
    s.set("broad_phase", "brute");
    EXPECT_EQ(s.real("slop"), 1e-3);
    EXPECT_EQ(s.integer("iterations"), 64);
    EXPECT_FALSE(s.toggle("bullets"));
    EXPECT_EQ(s.choice("broad_phase"), "brute");
    s.set("bullets", 1.0);
    s.set("broad_phase", 1.0);
    EXPECT_TRUE(s.toggle("bullets"));
    EXPECT_EQ(s.choice("broad_phase"), "quadtree");
}

TEST(Settings, TextReadsBackToTheSameValue) {
    Settings s(specs);
    s.set("slop", 1.0 / 3);
    s.set("bullets", "off");
    Settings t(specs);
    for (const SettingSpec& spec : specs) t.set(spec.name, s.text(spec.name));
    EXPECT_TRUE(s == t);
}

TEST(Settings, BadValuesAreRefusedAndChangeNothing) {
    struct Bad {
        const char *name, *value, *says;
    };
    const Bad all[] = {
        {"slop", "2", "'2' is not allowed; it takes a number from 0 to 1 m"},
        {"slop", "nan", "'nan' is not allowed"},
        {"slop", "inf", "'inf' is not allowed"},
        {"slop", "1e999", "'1e999' is not allowed"},
        {"slop", "0.5x", "'0.5x' is not allowed"},
        {"slop", "", "'' is not allowed"},
        {"iterations", "0", "a whole number from 1 to 64"},
        {"iterations", "1.5", "a whole number from 1 to 64"},
        {"iterations", " 4", "' 4' is not allowed"},
        {"bullets", "maybe", "it takes on or off"},
        {"broad_phase", "octree", "it takes one of brute, quadtree"},
        {"broad_phase", "", "it takes one of brute, quadtree"},
    };
    Settings s(specs);
    for (const Bad& bad : all)
        expect_error(error_of([&] { s.set(bad.name, bad.value); }), "setting " + std::string(bad.name) + ": ",
                     bad.says);
    expect_error(error_of([&] { s.set("broad_phase", 2.0); }), "setting broad_phase: ", "brute, quadtree");
    expect_error(error_of([&] { s.set("slop", std::numeric_limits<double>::quiet_NaN()); }),
                 "setting slop: ", "from 0 to 1");
    expect_error(error_of([&] { s.set("speed", "1"); }), "unknown setting 'speed'; known are ",
                 "slop, iterations, bullets, broad_phase");
    expect_error(error_of([&] { s.set("slo\x7f\u202e\n", "1"); }),
                 "unknown setting 'slo\\x7f\\u{202e}\\x0a'; ", "");
    EXPECT_TRUE(s == Settings(specs));
}

}  // namespace
}  // namespace flipside

#include "lab/tune/search_space.hpp"

#include <gtest/gtest.h>

#include "lab/contenders/engines.hpp"

namespace flipside::lab::tune {
namespace {

using Texts = std::vector<std::string>;

TEST(SearchSpace, HasBothOfAToggleAndAllOfAChoice) {
    EXPECT_EQ(candidates_of({.name = "t", .type = SettingType::toggle, .initial = 1, .about = ""}),
              (Texts{"on", "off"}));
    constexpr std::string_view choices[] = {"a", "b", "c"};
    EXPECT_EQ(candidates_of({.name = "c", .type = SettingType::choice, .choices = choices, .about = ""}),
              (Texts{"a", "b", "c"}));
}

TEST(SearchSpace, HasPowersOfTwoAroundAnIntegerWithinItsRange) {
    EXPECT_EQ(
        candidates_of(
            {.name = "i", .type = SettingType::integer, .initial = 8, .min = 1, .max = 40, .about = ""}),
        (Texts{"1", "2", "4", "8", "16", "32"}));
    EXPECT_EQ(candidates_of(
                  {.name = "i", .type = SettingType::integer, .initial = 0, .min = 0, .max = 4, .about = ""}),
              (Texts{"0", "1", "2", "4"}));
}

TEST(SearchSpace, HasHalfDecadesAroundARealOrBelowItsTop) {
    EXPECT_EQ(candidates_of({.name = "r", .initial = 2, .min = 0.5, .max = 30, .about = ""}),
              (Texts{"0.632", "2", "6.32", "20"}));
    EXPECT_EQ(candidates_of({.name = "r", .initial = 0, .min = 0, .max = 1, .about = ""}),
              (Texts{"0", "1e-06", "3.16e-06", "1e-05", "3.16e-05", "0.0001", "0.000316", "0.001", "0.00316",
                     "0.01", "0.0316", "0.1", "0.316", "1"}));
}

TEST(SearchSpace, EveryCandidateIsAllowed) {
    for (const Engine* engine : engines())
        for (const SettingSpec& spec : engine->settings) {
            Settings settings(engine->settings);
            const Texts texts = candidates_of(spec);
            EXPECT_GE(texts.size(), 2U) << spec.name;
            for (const std::string& text : texts) EXPECT_NO_THROW(settings.set(spec.name, text)) << spec.name;
        }
}

}  // namespace
}  // namespace flipside::lab::tune

#include "app/window/words.hpp"

#include <gtest/gtest.h>

namespace flipside::app {
namespace {

TEST(Words, ThousandsAreGrouped) {
    EXPECT_EQ(grouped(0), "0");
    EXPECT_EQ(grouped(999), "999");
    EXPECT_EQ(grouped(1000), "1,000");
    EXPECT_EQ(grouped(1234567), "1,234,567");
}

TEST(Words, EngineeringKeepsThreeFiguresAndTheUnit) {
    EXPECT_EQ(engineering(0, "J"), "0 J");
    EXPECT_EQ(engineering(12.34e-6, "s"), "12.3 µs");
    EXPECT_EQ(engineering(0.9999e-3, "s"), "1000 µs");
    EXPECT_EQ(engineering(1070, "J"), "1.07 kJ");
    EXPECT_EQ(engineering(-0.0021, "J", true), "−2.10 mJ");
    EXPECT_EQ(engineering(0.5, "J", true), "+500 mJ");
    EXPECT_EQ(engineering(3e-11, "m"), "30.0 pm");
}

TEST(Words, RadiiSpanAllPowersOfTen) {
    EXPECT_EQ(in_radii(0), "0 r");
    EXPECT_EQ(in_radii(123.4), "123 r");
    EXPECT_EQ(in_radii(12.06), "12.1 r");
    EXPECT_EQ(in_radii(0.996), "1.0 r");
    EXPECT_EQ(in_radii(0.31), "0.31 r");
    EXPECT_EQ(in_radii(2.14e-9), "2.1·10⁻⁹ r");
    EXPECT_EQ(in_radii(9.96e-13), "1.0·10⁻¹² r");
    EXPECT_EQ(power_of_ten(3), "10³");
}

TEST(Words, FormulasAndNumbersHaveRealMinusSigns) {
    EXPECT_EQ(with_minus_signs("separation = (c - p) · n - r"), "separation = (c − p) · n − r");
    EXPECT_EQ(with_minus_signs("-0.02 = 0.03 - 0.05 m"), "−0.02 = 0.03 − 0.05 m");
    EXPECT_EQ(with_minus_signs("(-1, -2e-05) m"), "(−1, −2e-05) m");
    EXPECT_EQ(with_minus_signs("v' = e^(-ct) v"), "v' = e^(−ct) v");
}

TEST(Words, BallsAreCountedAsPeopleCount) {
    EXPECT_EQ(balls_in_words(0, 0), "no balls");
    EXPECT_EQ(balls_in_words(1, 0), "1 ball");
    EXPECT_EQ(balls_in_words(11, 2), "11 balls, 2 asleep");
    EXPECT_EQ(balls_in_words(1200, 0), "1,200 balls");
}

TEST(Words, WhatRoundsToZeroHasNoSign) {
    EXPECT_EQ(with_unit(-0.0004, 3, "m/s"), "0.000 m/s");
    EXPECT_EQ(with_unit(-0.0005001, 3, "m/s"), "−0.001 m/s");
    EXPECT_EQ(with_unit(1e-9, 1, "", true), "0.0");
    EXPECT_EQ(with_unit(0.25, 2, "m/s", true), "+0.25 m/s");
}

TEST(Words, LinesBreakBetweenWordsAndNeverInANumberOrBeforeItsUnit) {
    using Lines = std::vector<std::string>;
    const auto letters = [](std::size_t most) {
        return [most](const std::string& words) { return words.size() <= most; };
    };
    EXPECT_EQ(in_lines("it has 0.7786 J.", letters(11)), (Lines{"it has", "0.7786 J."}));
    EXPECT_EQ(in_lines("a 12.5 m/s b", letters(8)), (Lines{"a", "12.5 m/s", "b"}));
    EXPECT_EQ(in_lines("in 2 steps", letters(4)), (Lines{"in 2", "step", "s"}));
    EXPECT_EQ(in_lines("one  two\n\nthree", letters(8)), (Lines{"one  two", "", "three"}));
    EXPECT_EQ(in_lines("µµµ", letters(5)), (Lines{"µµ", "µ"}));
    EXPECT_EQ(in_lines("", letters(5)), Lines{""});
    EXPECT_EQ(in_lines("one two three four", letters(8), 2), (Lines{"one two", "three…"}));
    EXPECT_EQ(in_lines("one two", letters(8), 1), Lines{"one two"});
    EXPECT_EQ(in_lines("one two", letters(8), 0), Lines{});
}

TEST(Words, AreShortenedByWholeLettersToWhatFits) {
    const auto bytes = [](std::size_t most) {
        return [most](const std::string& words) { return words.size() <= most; };
    };
    EXPECT_EQ(shortened("12.3 µs", bytes(8)), "12.3 µs");
    EXPECT_EQ(shortened("12.3 µs", bytes(7)), "12.3…");
    EXPECT_EQ(shortened("µµµ", bytes(5)), "µ…");
    EXPECT_EQ(shortened("µµµ", bytes(4)), "…");
    EXPECT_EQ(shortened("µ", bytes(0)), "…");
    EXPECT_EQ(shortened("", bytes(0)), "");
}

TEST(Words, PointsMayBeBelowZero) {
    EXPECT_EQ(points_in_words(12345), "12,345");
    EXPECT_EQ(points_in_words(0), "0");
    EXPECT_EQ(points_in_words(-50), "−50");
}

}  // namespace
}  // namespace flipside::app

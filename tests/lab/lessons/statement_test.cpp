#include "lab/lessons/statement.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace flipside::lab {
namespace {

const Figures figures = {{"one.y0", -1}, {"one.lost", 0}, {"two.y0", 2}, {"two.error_radii", INFINITY}};

bool holds(const std::string& statement) {
    return judge(statement, figures).holds;
}

std::string fault_of(const std::string& statement) {
    try {
        return judge(statement, figures).holds ? "holds" : "does not hold";
    } catch (const BadStatement& bad) {
        return bad.what();
    }
}

TEST(Statement, ComparesFiguresInEachOfSixWays) {
    EXPECT_TRUE(holds("one.y0 < two.y0") && !holds("two.y0 < one.y0") && !holds("one.y0 < -1"));
    EXPECT_TRUE(holds("one.y0<=-1") && !holds("one.y0 <= -2"));
    EXPECT_TRUE(holds("two.y0>one.y0") && !holds("two.y0 > 2"));
    EXPECT_TRUE(holds("two.y0 >= 2") && !holds("two.y0 >= 3"));
    EXPECT_TRUE(holds("one.lost == 0") && !holds("one.lost == 1"));
    EXPECT_TRUE(holds("one.lost != 1") && !holds("one.lost != 0"));
    EXPECT_TRUE(holds("abs((one.y0 + 1) * 3^2) < 1e-12 "));
    EXPECT_TRUE(holds("min(one.y0, two.y0) == max(-1, one.y0)"));
}

TEST(Statement, JoinsThemByAndBeforeOr) {
    const std::string yes = "one.lost == 0", no = "one.lost == 1";
    EXPECT_TRUE(holds(yes + "&&" + yes));
    EXPECT_FALSE(holds(yes + " && " + no));
    EXPECT_TRUE(holds(no + " || " + yes));
    EXPECT_TRUE(holds(yes + " || " + yes + " && " + no));
    EXPECT_FALSE(holds("(" + yes + " || " + yes + ") && " + no));
    EXPECT_TRUE(holds("((" + no + ") || (" + yes + ")) && (one.y0) < (two.y0)"));
}

TEST(Statement, NamesTheFiguresInIt) {
    EXPECT_EQ(judge("two.y0 > 5 && one.y0 < 3 * two.y0", figures).figures,
              (std::set<std::string>{"one.y0", "two.y0"}));
}

TEST(Statement, OfWhatIsInfiniteDoesNotHold) {
    EXPECT_FALSE(holds("two.error_radii < 1"));
    EXPECT_FALSE(holds("two.error_radii > 1"));
    EXPECT_FALSE(holds("1 / two.error_radii * two.error_radii == 0"));
}

TEST(Statement, IsRefusedWhereItIsNoComparison) {
    struct Bad {
        std::string statement, says;
    };
    const Bad all[] = {
        {"one.y0 = 3", "== is"},
        {"(one.y0 = 5) > 0", "== is"},
        {"one.y0 === 5", "== is"},
        {"one.y0 => 5", "== is"},
        {"1", "\"1\" is no comparison"},
        {"one.y0", "\"one.y0\" is no comparison"},
        {"(one.y0 > 0) + 1", "is no comparison"},
        {"one.y0 > 0 && 1", "\"1\" is no comparison"},
        {"one.lost == 0 || one.y0", "\"one.y0\" is no comparison"},
        {"one.y0 > 2, one.y0 > 1", "is no comparison"},
        {"one.y0 < 3, 4", "\" 3, 4\" is more than one value"},
        {"-2 < one.y0 < 2", "is no comparison"},
        {"one.y0 > 0 ? 1 : 0", "? : is no comparison"},
        {"1 < 2", "\"1 < 2\" compares no figure"},
        {"one.lost == 0 && 1 < 2", "\"1 < 2\" compares no figure"},
        {"1 / one.lost > 0", "is not finite: it compares inf and 0"},
        {"sqrt(one.y0) > 0", "is not finite"},
        {"one.lost == 0 || 1 / one.lost > 0", "is not finite"},
        {"", "is no comparison"},
        {"()", "is no comparison"},
        {"(one.y0 > 0", "is no comparison"},
        {"one.y0 > 0)", "arenthes"},
        {"(one.y0 > 0)(one.lost > 0)", "is no comparison"},
        {"one.y0 >", "xpression"},
        {"one.colour > 0", "one.colour"},
    };
    for (const Bad& bad : all)
        EXPECT_NE(fault_of(bad.statement).find(bad.says), std::string::npos)
            << bad.statement << ": " << fault_of(bad.statement);
}

}  // namespace
}  // namespace flipside::lab

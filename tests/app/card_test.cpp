#include "app/window/card.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "app/window/words.hpp"

namespace flipside::app {
namespace {

const Other ball = Other::ball(0);

/// The ball of "drop", which falls 1 m onto a floor of restitution 0.8.
Stage drop(const std::vector<std::string>& contenders) {
    return {"drop", "custom", View::split, {}, {}, contenders};
}

const std::vector<std::string>& cells(const Card& card, std::string_view label) {
    for (const Card::Row& row : card.rows)
        if (row.label == label) return row.cells;
    throw std::runtime_error("no row " + std::string(label));
}

bool has(const Card& card, std::string_view label) {
    for (const Card::Row& row : card.rows)
        if (row.label == label) return true;
    return false;
}

using Cells = std::vector<std::string>;

TEST(Card, TellsTheStateOfABallOnEveryContender) {
    Stage stage = drop({"ours=custom", "exact=reference"});
    stage.run_until(0.2);
    const auto card = card_of(stage, ball);
    ASSERT_TRUE(card);
    EXPECT_EQ(card->title, "ball 0");
    EXPECT_EQ(card->about, "80.0 g  ·  radius 13.5 mm  ·  steel");
    // 1013.5 mm − ½·9.81·0.2² m, 9.81·0.2 m/s; 0.08·9.81·1.0135 J are kept.
    EXPECT_EQ(cells(*card, "Position, mm"), (Cells(2, "0.0, 817.3")));
    EXPECT_EQ(cells(*card, "Velocity, m/s"), (Cells(2, "0.000, −1.962")));
    EXPECT_EQ(cells(*card, "Speed"), (Cells(2, "1.962 m/s")));
    EXPECT_EQ(cells(*card, "Spin"), (Cells(2, "0.00 rad/s")));
    EXPECT_EQ(cells(*card, "Energy"), (Cells(2, "795 mJ")));
    EXPECT_EQ(cells(*card, "Last impact"), (Cells(2, "none")));
    EXPECT_EQ(cells(*card, "Touches"), (Cells(2, "nothing")));
    EXPECT_FALSE(has(*card, "Speed before"));
}

TEST(Card, TellsTheLastImpactAsItIsToBe) {
    Stage stage = drop({"ours=custom", "exact=reference"});
    stage.run_until(0.5);
    for (const auto& card : {card_of(stage, ball), card_of(stage, {})}) {
        ASSERT_TRUE(card);
        // √(2/9.81) s, √(2·9.81) m/s, 0.08·1.8 of that in N·s.
        EXPECT_EQ(cells(*card, "Last impact"), (Cells(2, "floor\n0.4515 s")));
        EXPECT_EQ(cells(*card, "Speed before"), (Cells(2, "4.429 m/s")));
        EXPECT_EQ(cells(*card, "Speed after"), (Cells(2, "3.544 m/s")));
        EXPECT_EQ(cells(*card, "Restitution"), (Cells(2, "0.800 of 0.800")));
        EXPECT_EQ(cells(*card, "Impulse"), (Cells(2, "638 mN·s")));
        EXPECT_EQ(cells(*card, "Normal"), (Cells(2, "90.0°")));
        EXPECT_EQ(cells(*card, "Wrong by"), (Cells{"on time\nnormal exact", ""}));
    }
    EXPECT_EQ(cells(*card_of(stage, Other::part(0)), "Last impact"), (Cells(2, "ball 0\n0.4515 s")));
}

TEST(Card, TellsHowLateAnImpactIs) {
    Stage stage = drop({"b=box2d,dt=1/20", "exact=reference"});
    stage.run_until(0.6);
    const auto card = card_of(stage, ball);
    const auto late = stage.run_named("b").impacts().last(ball, 0.6)->event.time - std::sqrt(2 / 9.81);
    EXPECT_NE(late, 0);
    EXPECT_EQ(cells(*card, "Wrong by")[0],
              engineering(std::abs(late), "s") + (late > 0 ? " late" : " early") + "\nnormal exact");
}

TEST(Card, WithoutTheReferenceNothingIsSaidToBeWrong) {
    Stage stage = drop({"ours=custom", "b=box2d"});
    stage.run_until(0.6);
    EXPECT_FALSE(has(*card_of(stage, ball), "Wrong by"));
}

TEST(Card, TellsWhatIsTouchedAndSaysWhatIsNotTold) {
    Stage stage = drop({"ours=custom"});
    stage.run_until(5);
    auto card = card_of(stage, ball);
    EXPECT_EQ(cells(*card, "Touches"), Cells{"floor"});
    EXPECT_EQ(cells(*card, "  normal"), Cells{"90.0°"});
    EXPECT_EQ(cells(*card, "  impulse"), Cells{"not told"});
    EXPECT_EQ(cells(*card, "  restitution"), Cells{"not told"});
    card = card_of(stage, Other::part(0));
    EXPECT_EQ(card->title, "floor");
    EXPECT_EQ(cells(*card, "Touches"), Cells{"ball 0"});
    EXPECT_EQ(cells(*card, "  normal"), Cells{"−90.0°"});
}

TEST(Card, OfThePastIsAsItWas) {
    Stage stage = drop({"ours=custom", "exact=reference"});
    stage.run_until(0.6);
    const std::vector<Card::Row> then = card_of(stage, ball)->rows;
    stage.run_until(1.5);
    EXPECT_NE(cells(*card_of(stage, ball), "Last impact")[0], then[5].cells[0]);
    stage.go_to(0.6);
    const std::vector<Card::Row> again = card_of(stage, ball)->rows;
    ASSERT_EQ(again.size(), then.size());
    for (std::size_t i = 0; i < then.size(); ++i) EXPECT_EQ(again[i].cells, then[i].cells) << then[i].label;
}

TEST(Card, OfABallThatIsGoneSaysSoAndOfNoPartThereIsNone) {
    Stage stage = drop({"ours=custom"});
    EXPECT_EQ(card_of(stage, Other::ball(7))->about, "gone");
    EXPECT_FALSE(card_of(stage, Other::part(7)));
    EXPECT_EQ(card_of(stage, {})->about, "none yet");
}

}  // namespace
}  // namespace flipside::app

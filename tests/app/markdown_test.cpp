#include "app/window/markdown.hpp"

#include <gtest/gtest.h>

namespace flipside::app {
namespace {

using Kind = TextBlock::Kind;

TEST(Markdown, HasHeadingsParagraphsListsAndCode) {
    const auto blocks =
        parse_markdown("# One\n\nA **b** and `c`\nd.\n\n1. first\n2. second\n\n- dot\n\nend\n\n    code\n");
    ASSERT_EQ(blocks.size(), 7U);
    EXPECT_EQ(blocks[0].kind, Kind::heading);
    EXPECT_EQ(blocks[0].runs[0].words, "One");
    EXPECT_EQ(blocks[1].kind, Kind::paragraph);
    EXPECT_EQ(blocks[1].runs[1], (TextRun{"b", true, false, false}));
    EXPECT_EQ(blocks[1].runs[3], (TextRun{"c", false, false, true}));
    EXPECT_EQ(blocks[2].kind, Kind::item);
    EXPECT_EQ(blocks[2].number, 1);
    EXPECT_EQ(blocks[3].number, 2);
    EXPECT_EQ(blocks[4].kind, Kind::item);
    EXPECT_EQ(blocks[4].number, 0);
    EXPECT_EQ(blocks[6].kind, Kind::code);
    EXPECT_EQ(blocks[6].runs[0].words, "code");
}

TEST(Markdown, CommandsNothing) {
    for (const auto& block : parse_markdown("a \x1b[31m <b>c</b> \u202e d\n\n<script>x</script>\n"))
        for (const TextRun& run : block.runs)
            for (const char c : run.words) EXPECT_FALSE(c >= 0 && c < ' ' && c != '\n') << run.words;
}

TEST(Markdown, TakesWhateverComes) {
    EXPECT_TRUE(parse_markdown("").empty());
    EXPECT_FALSE(parse_markdown("***\n[x](y) ![z](w)\n> q\n| a |\n|---|\n").empty());
    EXPECT_TRUE(parse_markdown(std::string(20000, '>')).empty());
}

}  // namespace
}  // namespace flipside::app

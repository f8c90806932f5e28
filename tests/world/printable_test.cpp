#include "world/printable.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "world/json_file.hpp"

namespace flipside {
namespace {

TEST(Printable, LeavesTextAsItIs) {
    for (const char* text : {"", "plain", "Übung µ – 10⁻³ · 台球 🎱", "a\\b \\x1b", "<&>\"'%s$1`"}) {
        EXPECT_EQ(printable(text), text);
        EXPECT_EQ(printable_lines(text), text);
    }
}

TEST(Printable, ShowsControlCharactersAsEscapes) {
    EXPECT_EQ(printable("a\nb\r\t\x1b[31m\x7f"), "a\\x0ab\\x0d\\x09\\x1b[31m\\x7f");
    EXPECT_EQ(printable(std::string_view("\0", 1)), "\\x00");
    EXPECT_EQ(printable("\u0080\u009b\u009f\u00a0"), "\\u{80}\\u{9b}\\u{9f}\u00a0");
    EXPECT_EQ(printable_lines("a\nb\r\n"), "a\nb\\x0d\n");
}

TEST(Printable, ShowsWhatTurnsOrHidesTextAsEscapes) {
    for (const int c : {0xad, 0x61c, 0x200b, 0x200e, 0x200f, 0x2028, 0x2029, 0x202a, 0x202b, 0x202c, 0x202d,
                        0x202e, 0x2066, 0x2067, 0x2068, 0x2069, 0xfeff, 0xffff}) {
        char text[4] = {static_cast<char>(0xe0 | c >> 12), static_cast<char>(0x80 | (c >> 6 & 0x3f)),
                        static_cast<char>(0x80 | (c & 0x3f)), 0};
        const char* begin = text;
        char two[3] = {static_cast<char>(0xc0 | (c >> 6 & 0x1f)), static_cast<char>(0x80 | (c & 0x3f)), 0};
        if (c < 0x800) begin = two;
        char expected[16];
        std::snprintf(expected, sizeof expected, "\\u{%x}", static_cast<unsigned>(c));
        EXPECT_EQ(printable(begin), expected);
    }
    EXPECT_EQ(printable("\U000E0041"), "\\u{e0041}");  // a tag
}

TEST(Printable, ShowsBytesThatAreNoUtf8AsEscapes) {
    EXPECT_EQ(printable("\xff\xfe"), "\\xff\\xfe");
    EXPECT_EQ(printable("a\xc3"), "a\\xc3");                  // cut
    EXPECT_EQ(printable("\xc0\x8a"), "\\xc0\\x8a");           // a line end, overlong
    EXPECT_EQ(printable("\xed\xa0\x80"), "\\xed\\xa0\\x80");  // half a surrogate pair
    EXPECT_EQ(printable("\x9b"
                        "31m"),
              "\\x9b31m");
    EXPECT_EQ(printable("\xe2\x80z"), "\\xe2\\x80z");
}

/// Whatever the bytes: printable text stays as it is, is in one line and valid UTF-8.
TEST(Printable, IsTheSameWhenAppliedTwice) {
    for (int a = 0; a < 256; ++a)
        for (int b = 0; b < 256; ++b)
            for (const char* end : {"", "\x80", "\x80\xae"}) {
                const std::string once =
                    printable(std::string{static_cast<char>(a), static_cast<char>(b)} + end);
                ASSERT_EQ(printable(once), once);
                ASSERT_NO_THROW(static_cast<void>(nlohmann::json(once).dump()));
                for (const char c : once) ASSERT_TRUE((c >= ' ' || c < 0) && c != 0x7f);
            }
}

TEST(JsonText, IsAscii) {
    const Json json{{"a\u202e", "\x1b\u009b\x7f\xff µ"}};
    const std::string text = json_text(json);
    EXPECT_EQ(text, R"({"a\u202e":"\u001b\u009b\u007f\ufffd \u00b5"})");
    EXPECT_EQ(json_text(Json{1, 2}, 1), "[\n 1,\n 2\n]");
}

}  // namespace
}  // namespace flipside

#pragma once
/// Markdown as the window writes it: headings, paragraphs, lists, code, bold and emphasis. Links and pictures
/// are shown as their words; raw HTML as what it says.

#include <string>
#include <string_view>
#include <vector>

namespace flipside::app {

struct TextRun {
    std::string words;
    bool strong = false, emphasised = false, code = false;
    friend bool operator==(const TextRun&, const TextRun&) = default;
};

struct TextBlock {
    enum class Kind { heading, paragraph, item, code } kind = Kind::paragraph;
    int number = 0;  ///< of an item in a numbered list, from 1; 0 in others
    std::vector<TextRun> runs;
};

/// Reads it with md4c; text in it is printable().
[[nodiscard]] std::vector<TextBlock> parse_markdown(std::string_view text);

/// Writes it where ImGui's cursor is, wrapped at the right border of the window.
void draw_markdown(const std::vector<TextBlock>& blocks);

}  // namespace flipside::app

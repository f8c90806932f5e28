#include "app/window/markdown.hpp"

#include <imgui.h>
#include <md4c.h>

#include "app/window/panel_parts.hpp"
#include "app/window/words.hpp"
#include "world/printable.hpp"

namespace flipside::app {

namespace {

/// Collects what md4c calls out.
struct Reader {
    std::vector<TextBlock> blocks;
    std::vector<int> numbers;  ///< of the next item of each list that is open; 0: not numbered
    TextRun style;
    int item = -1;  ///< number of the item that has just begun; −1: none

    void begin(TextBlock::Kind kind) {
        blocks.push_back({kind, 0, {}});
        if (item < 0 || kind == TextBlock::Kind::code) return;
        blocks.back().kind = TextBlock::Kind::item;
        blocks.back().number = item;
        item = -1;
    }
    void add(std::string_view words) {
        if (blocks.empty() || item >= 0)
            begin(TextBlock::Kind::paragraph);  // items of tight lists have no paragraph
        TextRun run = style;
        run.words = blocks.back().kind == TextBlock::Kind::code ? printable_lines(words) : printable(words);
        blocks.back().runs.push_back(std::move(run));
    }

    static Reader& of(void* reader) { return *static_cast<Reader*>(reader); }

    static int enter_block(MD_BLOCKTYPE type, void* detail, void* self) {
        Reader& reader = of(self);
        if (type == MD_BLOCK_H) reader.begin(TextBlock::Kind::heading);
        if (type == MD_BLOCK_P) reader.begin(TextBlock::Kind::paragraph);
        if (type == MD_BLOCK_CODE) reader.begin(TextBlock::Kind::code);
        if (type == MD_BLOCK_UL) reader.numbers.push_back(0);
        if (type == MD_BLOCK_OL)
            reader.numbers.push_back(static_cast<int>(static_cast<MD_BLOCK_OL_DETAIL*>(detail)->start));
        if (type == MD_BLOCK_LI && !reader.numbers.empty()) {
            int& number = reader.numbers.back();
            reader.item = number;
            if (number > 0) ++number;
        }
        return 0;
    }
    static int leave_block(MD_BLOCKTYPE type, void*, void* self) {
        if ((type == MD_BLOCK_UL || type == MD_BLOCK_OL) && !of(self).numbers.empty())
            of(self).numbers.pop_back();
        return 0;
    }
    static int span(MD_SPANTYPE type, void* self, bool on) {
        TextRun& style = of(self).style;
        if (type == MD_SPAN_STRONG) style.strong = on;
        if (type == MD_SPAN_EM) style.emphasised = on;
        if (type == MD_SPAN_CODE) style.code = on;
        return 0;
    }
    static int enter_span(MD_SPANTYPE type, void*, void* self) { return span(type, self, true); }
    static int leave_span(MD_SPANTYPE type, void*, void* self) { return span(type, self, false); }
    static int text(MD_TEXTTYPE type, const MD_CHAR* words, MD_SIZE size, void* self) {
        const bool line_end = type == MD_TEXT_SOFTBR || type == MD_TEXT_BR;
        of(self).add(line_end ? std::string_view(" ") : std::string_view(words, size));
        return 0;
    }
};

sf::Color colour_of(const TextRun& run) {
    if (run.code) return colour::cells;
    if (run.strong) return colour::lit;
    return run.emphasised ? colour::pairs : colour::text;
}

/// Words one after another, each in its colour; a line ends where the next has no room.
void draw_runs(const std::vector<TextRun>& runs, float indent) {
    const float left = ImGui::GetCursorPosX() + indent, right = ImGui::GetContentRegionMax().x;
    const float space = ImGui::CalcTextSize(" ").x;
    float x = left;
    bool first = true, gap = false;
    for (const TextRun& run : runs) {
        ImGui::PushStyleColor(ImGuiCol_Text, imgui_color(colour_of(run)));
        std::string_view rest = run.words;
        while (!rest.empty()) {
            if (rest.front() == ' ') {
                gap = true;
                rest.remove_prefix(1);
                continue;
            }
            const std::string_view word = rest.substr(0, end_of_word(rest));
            rest.remove_prefix(word.size());
            const float width = ImGui::CalcTextSize(word.data(), word.data() + word.size()).x;
            const float at = x + (gap && !first ? space : 0);
            const bool fits = first || at + width <= right;
            if (!first && fits) ImGui::SameLine(0, 0);
            x = fits ? at : left;
            ImGui::SetCursorPosX(x);
            ImGui::TextUnformatted(word.data(), word.data() + word.size());
            x += width;
            first = gap = false;
        }
        ImGui::PopStyleColor();
    }
}

}  // namespace

std::vector<TextBlock> parse_markdown(std::string_view text) {
    Reader reader;
    MD_PARSER parser{};
    parser.flags = MD_FLAG_NOHTML;
    parser.enter_block = Reader::enter_block;
    parser.leave_block = Reader::leave_block;
    parser.enter_span = Reader::enter_span;
    parser.leave_span = Reader::leave_span;
    parser.text = Reader::text;
    static_cast<void>(md_parse(text.data(), static_cast<MD_SIZE>(text.size()), &parser, &reader));
    return std::move(reader.blocks);
}

void draw_markdown(const std::vector<TextBlock>& blocks) {
    const float step = ImGui::GetFontSize();
    for (const TextBlock& block : blocks) {
        switch (block.kind) {
            case TextBlock::Kind::heading:
                ImGui::PushFont(ImGui::GetIO().Fonts->Fonts[1]);
                draw_runs(block.runs, 0);
                ImGui::PopFont();
                break;
            case TextBlock::Kind::paragraph:
                draw_runs(block.runs, 0);
                break;
            case TextBlock::Kind::item: {
                const std::string mark = block.number > 0 ? std::to_string(block.number) + "." : "·";
                const float left = ImGui::GetCursorPosX();
                ImGui::TextUnformatted(mark.c_str());
                ImGui::SameLine(0, 0);
                ImGui::SetCursorPosX(left);
                draw_runs(block.runs, 1.4F * step);
                break;
            }
            case TextBlock::Kind::code:
                for (const TextRun& run : block.runs)
                    if (run.words != "\n") wrapped(run.words, colour::cells);
        }
        ImGui::Dummy({0, 0.25F * step});
    }
}

}  // namespace flipside::app

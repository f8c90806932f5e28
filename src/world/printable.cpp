#include "world/printable.hpp"

#include <algorithm>
#include <cstdio>

#include <boost/locale/utf.hpp>

namespace flipside {

namespace {

namespace utf = boost::locale::utf;

struct Range {
    utf::code_point first, last;
};
/// Unicode's control and format characters, line separators and noncharacters of the first plane.
constexpr Range unseen[] = {{0x00, 0x1f},     {0x7f, 0x9f},     {0xad, 0xad},     {0x61c, 0x61c},
                            {0x180e, 0x180e}, {0x200b, 0x200f}, {0x2028, 0x202e}, {0x2060, 0x206f},
                            {0xfdd0, 0xfdef}, {0xfeff, 0xfeff}, {0xfff9, 0xfffb}, {0xfffe, 0xffff}};

bool is_seen(utf::code_point c) {
    constexpr Range tags{0xe0000, 0xe0fff};
    if (c >= tags.first && c <= tags.last) return false;
    return std::ranges::none_of(unseen, [c](const Range& r) { return c >= r.first && c <= r.last; });
}

std::string escape_of(const char* format, unsigned code) {
    char text[16];
    std::snprintf(text, sizeof text, format, code);
    return text;
}

std::string escaped(std::string_view text, bool keep_line_ends) {
    std::string out;
    for (auto at = text.begin(); at != text.end();) {
        auto next = at;
        const utf::code_point c = utf::utf_traits<char>::decode(next, text.end());
        if (c == utf::illegal || c == utf::incomplete) {
            out += escape_of("\\x%02x", static_cast<unsigned char>(*at));
            ++at;
            continue;
        }
        if (is_seen(c) || (keep_line_ends && c == '\n'))
            out.append(at, next);
        else
            out += escape_of(c < 0x80 ? "\\x%02x" : "\\u{%x}", c);
        at = next;
    }
    return out;
}

}  // namespace

std::string printable(std::string_view text) {
    return escaped(text, false);
}

std::string printable_lines(std::string_view text) {
    return escaped(text, true);
}

}  // namespace flipside

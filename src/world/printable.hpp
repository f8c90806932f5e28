#pragma once
/// Text from elsewhere (files, arguments, names of files) as a terminal, a window or a line of text may show
/// it.

#include <string>
#include <string_view>

namespace flipside {

/// One line of valid UTF-8 that shows what is there and commands nothing. Shown as escapes are
///   - control characters, line ends among them: ESC as \x1b, U+009B as \u{9b};
///   - characters that turn the direction of text or cannot be seen: U+202E as \u{202e};
///   - bytes that are no UTF-8: \xff.
/// All else stays, backslashes too, so what was escaped once is not changed by doing so again.
[[nodiscard]] std::string printable(std::string_view text);

/// The same, but line ends (\n) stay: for text of several lines whose parts from elsewhere are printable().
[[nodiscard]] std::string printable_lines(std::string_view text);

}  // namespace flipside

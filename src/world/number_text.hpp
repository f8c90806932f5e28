#pragma once
/// A number as the shortest text that reads back to the same bits, in any locale: "0.5", "1e+30".

#include <charconv>
#include <string>

namespace flipside {

[[nodiscard]] inline std::string number_text(double value) {
    char text[32];
    return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

}  // namespace flipside

#pragma once
/// Numbers in the names of quantities.

#include <sstream>
#include <string>

namespace flipside::lab {

/// As %g would: "0.5", "1e+06".
[[nodiscard]] inline std::string text_of(auto number) {
    std::ostringstream text;
    text << number;
    return text.str();
}

}  // namespace flipside::lab

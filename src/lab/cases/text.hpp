#pragma once
/// Numbers in the names of quantities.

#include <iomanip>
#include <sstream>
#include <string>

namespace flipside::lab {

/// As %g would with so many digits: "0.5", "1e+06".
[[nodiscard]] inline std::string text_of(auto number, int digits = 6) {
    std::ostringstream text;
    text << std::setprecision(digits) << number;
    return text.str();
}

}  // namespace flipside::lab

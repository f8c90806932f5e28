#pragma once
/// Text in HTML and SVG.

#include <string>
#include <string_view>

namespace flipside::lab::report {

/// As text of an element or value of an attribute: & < > and both quotes as entities, what is not printable()
/// as its escape. Line ends stay.
[[nodiscard]] std::string escape(std::string_view text);

}  // namespace flipside::lab::report

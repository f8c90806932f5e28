#pragma once
/// A field for a line of text.

#include <string>

namespace flipside::app {

/// At most `most` bytes. True while it is edited, or, with `on_enter`, once Enter is pressed in it.
bool text_field(const char* id, std::string& text, std::size_t most, bool on_enter = false);

}  // namespace flipside::app

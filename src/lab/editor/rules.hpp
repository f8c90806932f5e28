#pragma once
/// Names of parts in the rules of a scene's document.

#include "lab/editor/json_text.hpp"

namespace flipside::lab {

/// The rules with another name for a part. Where that is "", what was said of the part is left out, and so
/// are groups without members.
[[nodiscard]] OrderedJson with_name(const OrderedJson& rules, const std::string& before,
                                    const std::string& after);

}  // namespace flipside::lab

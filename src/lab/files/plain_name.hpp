#pragma once
/// Names that become names of files, ids in a page, series of a figure and fields of a table. They mean
/// nothing to any of these languages, so that a file from elsewhere cannot say anything by them.

#include <string_view>

namespace flipside::lab {

/// What is allowed, for messages.
inline constexpr std::string_view plain_name_rule =
    "1 to 100 letters, digits, '.', '_' and '-', the first a letter or digit";

[[nodiscard]] bool is_plain_name(std::string_view name);

}  // namespace flipside::lab

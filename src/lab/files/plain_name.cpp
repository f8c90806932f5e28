#include "lab/files/plain_name.hpp"

#include <algorithm>

namespace flipside::lab {

bool is_plain_name(std::string_view name) {
    constexpr std::size_t longest = 100;
    const auto is_letter_or_digit = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    };
    if (name.empty() || name.size() > longest || !is_letter_or_digit(name.front())) return false;
    return std::ranges::all_of(
        name, [&](char c) { return is_letter_or_digit(c) || c == '.' || c == '_' || c == '-'; });
}

}  // namespace flipside::lab

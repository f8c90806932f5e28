#pragma once
/// Numbers as people read them: grouped thousands, a unit always, a real minus sign.

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace flipside::app {

/// "1,234,567".
[[nodiscard]] std::string grouped(std::uint64_t number);
/// "1,234", "−50".
[[nodiscard]] std::string points_in_words(long points);
/// `value` with `digits` after the point and a unit: "−0.25 m/s"; `sign` writes a plus too.
[[nodiscard]] std::string with_unit(double value, int digits, const std::string& unit, bool sign = false);
/// In a formula or numbers, with real minus signs: "c − p", "(−1, 2)". Hyphens in words and in exponents
/// stay.
[[nodiscard]] std::string with_minus_signs(std::string_view text);
/// Three figures and the unit with the prefix that suits (p … k): "12.3 µs", "1.07 kJ", "0 J".
[[nodiscard]] std::string engineering(double value, const std::string& unit, bool sign = false);
/// With a capital letter in front.
[[nodiscard]] std::string sentence(std::string_view words);
/// A power of ten: "10⁻⁹".
[[nodiscard]] std::string power_of_ten(int exponent);
/// A length in radii of its ball: "12.1 r", "0.31 r", "2.1·10⁻⁹ r", "0 r".
[[nodiscard]] std::string in_radii(double radii);
/// A step: "1/60 s", "0.01 s", "1/97 s".
[[nodiscard]] std::string step_in_words(double dt);
/// "position_before" as people write it.
[[nodiscard]] std::string with_spaces(std::string_view name);
/// "1 ball", "11 balls, 2 asleep", "no balls".
[[nodiscard]] std::string balls_in_words(std::size_t balls, std::size_t asleep);
/// Where the first word of a text ends that begins with one. A number and its unit are one word: "0.7786 J".
[[nodiscard]] std::size_t end_of_word(std::string_view text);
inline constexpr std::size_t any_number = ~std::size_t{0};
/// In lines that fit, broken between words; only a word that does not fit alone is broken between letters.
/// What is left for the last of `most` lines is shortened.
[[nodiscard]] std::vector<std::string> in_lines(std::string_view text,
                                                const std::function<bool(const std::string&)>& fits,
                                                std::size_t most = any_number);
/// As much of a text in UTF-8 as `fits`, with an ellipsis behind it where that is not all.
[[nodiscard]] std::string shortened(std::string words, const std::function<bool(const std::string&)>& fits);

}  // namespace flipside::app

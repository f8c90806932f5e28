#include "app/window/words.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>

namespace flipside::app {

std::string grouped(std::uint64_t number) {
    std::string digits = std::to_string(number);
    for (auto at = static_cast<std::ptrdiff_t>(digits.size()) - 3; at > 0; at -= 3)
        digits.insert(static_cast<std::size_t>(at), 1, ',');
    return digits;
}

std::string points_in_words(long points) {
    const auto size = static_cast<std::uint64_t>(points);
    return points < 0 ? "−" + grouped(0 - size) : grouped(size);
}

std::string with_unit(double value, int digits, const std::string& unit, bool sign) {
    char number[64];
    std::snprintf(number, sizeof number, "%.*f", digits, std::abs(value));
    const std::string minus = value < 0 ? "−" : sign ? "+" : "";
    return minus + number + (unit.empty() ? "" : " " + unit);
}

std::string engineering(double value, const std::string& unit, bool sign) {
    static constexpr const char* prefixes[] = {"p", "n", "µ", "m", "", "k"};
    if (std::abs(value) < 1e-13) return "0 " + unit;
    const int power = static_cast<int>(std::floor(std::log10(std::abs(value)) / 3));
    const int prefix = std::clamp(power + 4, 0, 5);
    const double scaled = value / std::pow(1000.0, prefix - 4);
    const double size = std::abs(scaled);
    return with_unit(scaled, size < 9.995 ? 2 : size < 99.95 ? 1 : 0, prefixes[prefix] + unit, sign);
}

std::string sentence(std::string_view words) {
    std::string text(words);
    if (!text.empty()) text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
    return text;
}

std::string power_of_ten(int exponent) {
    static constexpr const char* raised[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string words = exponent < 0 ? "10⁻" : "10";
    for (const char digit : std::to_string(std::abs(exponent))) words += raised[digit - '0'];
    return words;
}

std::string in_radii(double radii) {
    if (radii == 0) return "0 r";
    char number[64];
    std::snprintf(number, sizeof number, "%.1e", radii);
    const std::string scientific = number;  // as 2.1e-09
    const int exponent = std::stoi(scientific.substr(scientific.find('e') + 1));
    if (exponent < -2) return scientific.substr(0, 3) + "·" + power_of_ten(exponent) + " r";
    return with_unit(radii, exponent < 0 ? 2 : exponent < 2 ? 1 : 0, "r");
}

std::string step_in_words(double dt) {
    const double rate = 1 / dt;
    if (dt < 1 && std::abs(rate - std::round(rate)) < 1e-9 * rate)
        return "1/" + grouped(static_cast<std::uint64_t>(std::llround(rate))) + " s";
    return engineering(dt, "s");
}

std::string balls_in_words(std::size_t balls, std::size_t asleep) {
    if (balls == 0) return "no balls";
    std::string words = grouped(balls) + (balls == 1 ? " ball" : " balls");
    if (asleep > 0) words += ", " + grouped(asleep) + " asleep";
    return words;
}

std::string shortened(std::string words, const std::function<bool(const std::string&)>& fits) {
    if (fits(words)) return words;
    const std::string rest = "…";
    while (!words.empty() && !fits(words + rest)) {
        // The bytes that go on with a letter go with it.
        while (words.size() > 1 && (static_cast<unsigned char>(words.back()) & 0xc0U) == 0x80U)
            words.pop_back();
        words.pop_back();
    }
    return words + rest;
}

}  // namespace flipside::app

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
    // What rounds to zero has no sign.
    const bool zero = std::string_view(number).find_first_of("123456789in") == std::string_view::npos;
    const std::string minus = zero ? "" : value < 0 ? "−" : sign ? "+" : "";
    return minus + number + (unit.empty() ? "" : " " + unit);
}

std::string with_minus_signs(std::string_view text) {
    std::string words;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool first = i == 0 || text[i - 1] == ' ' || text[i - 1] == '(';
        if (text[i] == '-' && first)
            words += "−";
        else
            words += text[i];
    }
    return words;
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

std::string with_spaces(std::string_view name) {
    std::string words(name);
    std::ranges::replace(words, '_', ' ');
    return words;
}

std::string balls_in_words(std::size_t balls, std::size_t asleep) {
    if (balls == 0) return "no balls";
    std::string words = grouped(balls) + (balls == 1 ? " ball" : " balls");
    if (asleep > 0) words += ", " + grouped(asleep) + " asleep";
    return words;
}

namespace {

/// "m/s", "µs", "N·s", "mJ", "%", also with punctuation behind it.
bool is_unit(std::string_view word) {
    while (!word.empty() && std::string_view(".,;:!?)").find(word.back()) != std::string_view::npos)
        word.remove_suffix(1);
    constexpr std::string_view units[] = {"m", "s", "J", "g", "r", "Hz", "N", "N·s", "rad", "px", "%", "×"};
    constexpr std::string_view prefixes[] = {"", "p", "n", "µ", "m", "k"};
    for (const std::string_view unit : units)
        for (const std::string_view prefix : prefixes) {
            if (!word.starts_with(prefix) || !word.substr(prefix.size()).starts_with(unit)) continue;
            const std::string_view rest = word.substr(prefix.size() + unit.size());
            if (rest.empty() || rest.front() == '/' || rest == "²" || rest == "³") return true;
        }
    return false;
}

/// As many bytes of a text as fit, whole letters and at least one.
std::size_t fitting(std::string_view text, const std::function<bool(const std::string&)>& fits) {
    const auto after = [text](std::size_t at) {
        for (++at; at < text.size() && (static_cast<unsigned char>(text[at]) & 0xc0U) == 0x80U;) ++at;
        return at;
    };
    std::size_t end = after(0);
    while (end < text.size() && fits(std::string(text.substr(0, after(end))))) end = after(end);
    return end;
}

/// The same of a text without line ends.
void break_line(std::string_view text, const std::function<bool(const std::string&)>& fits,
                std::vector<std::string>& lines) {
    std::string line;
    bool begun = false;
    while (!text.empty()) {
        const std::size_t begin = std::min(text.find_first_not_of(' '), text.size());
        const std::string gap(text.substr(0, begin));
        text.remove_prefix(begin);
        std::string_view word = text.substr(0, end_of_word(text));
        text.remove_prefix(word.size());
        if (!begun || fits(line + gap + std::string(word))) {
            line += gap + std::string(word);
        } else {
            lines.push_back(std::move(line));
            line = word;
        }
        begun = true;
        while (!fits(line)) {
            const std::size_t end = fitting(line, fits);
            if (end == line.size()) break;
            lines.push_back(line.substr(0, end));
            line.erase(0, end);
        }
    }
    lines.push_back(std::move(line));
}

}  // namespace

std::size_t end_of_word(std::string_view text) {
    const std::size_t end = std::min(text.find(' '), text.size());
    if (end == 0 || end == text.size() || text[end - 1] < '0' || text[end - 1] > '9') return end;
    const std::string_view rest = text.substr(end + 1);
    const std::string_view next = rest.substr(0, rest.find(' '));
    return is_unit(next) ? end + 1 + next.size() : end;
}

std::vector<std::string> in_lines(std::string_view text, const std::function<bool(const std::string&)>& fits,
                                  std::size_t most) {
    if (most == 0) return {};
    std::vector<std::string> lines;
    for (std::size_t end = 0; end != std::string_view::npos;) {
        end = text.find('\n');
        break_line(text.substr(0, end), fits, lines);
        if (end != std::string_view::npos) text.remove_prefix(end + 1);
    }
    if (lines.size() <= most) return lines;
    for (std::size_t i = most; i < lines.size(); ++i) (lines[most - 1] += ' ') += lines[i];
    lines.resize(most);
    lines.back() = shortened(std::move(lines.back()), fits);
    return lines;
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

#include "lab/lessons/statement.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <vector>

#include <muParser.h>

#include "world/json_file.hpp"
#include "world/number_text.hpp"

namespace flipside::lab {

namespace {

using Text = std::string_view;

constexpr Text blanks = " \t\r\n";

Text trimmed(Text text) {
    const std::size_t first = text.find_first_not_of(blanks);
    if (first == Text::npos) return {};
    return text.substr(first, text.find_last_not_of(blanks) + 1 - first);
}

/// Places of the characters that stand in no parentheses; those themselves are left out.
std::vector<std::size_t> outside_parentheses(Text text) {
    std::vector<std::size_t> places;
    int depth = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == ')') --depth;
        if (depth == 0 && text[i] != '(' && text[i] != ')') places.push_back(i);
        if (text[i] == '(') ++depth;
    }
    return places;
}

std::vector<Text> split(Text text, Text at) {
    std::vector<Text> parts;
    std::size_t begin = 0;
    for (const std::size_t place : outside_parentheses(text)) {
        if (place < begin || !text.substr(place).starts_with(at)) continue;
        parts.push_back(text.substr(begin, place - begin));
        begin = place + at.size();
    }
    parts.push_back(text.substr(begin));
    return parts;
}

struct Sign {
    Text text;
    bool (*holds)(double, double);
};
/// Longer ones first.
constexpr Sign signs[] = {
    {"<=", [](double a, double b) { return a <= b; }}, {">=", [](double a, double b) { return a >= b; }},
    {"==", [](double a, double b) { return a == b; }}, {"!=", [](double a, double b) { return a != b; }},
    {"<", [](double a, double b) { return a < b; }},   {">", [](double a, double b) { return a > b; }}};

const Sign* sign_at(Text text, std::size_t place) {
    const auto* found = std::ranges::find_if(
        signs, [&](const Sign& sign) { return text.substr(place).starts_with(sign.text); });
    return found == std::end(signs) ? nullptr : found;
}

struct Comparison {
    Text left, right;
    const Sign* sign;
};

/// Nothing where it is none, or more than one.
std::optional<Comparison> comparison_in(Text text) {
    std::optional<Comparison> found;
    std::size_t after = 0;
    for (const std::size_t place : outside_parentheses(text)) {
        const Sign* sign = place < after ? nullptr : sign_at(text, place);
        if (sign == nullptr) continue;
        if (found) return std::nullopt;
        after = place + sign->text.size();
        found = {text.substr(0, place), text.substr(after), sign};
    }
    return found;
}

bool is_in_parentheses(Text text) {
    return text.starts_with('(') && text.ends_with(')') && outside_parentheses(text).empty();
}

class Judge {
  public:
    explicit Judge(const Figures& figures) : figures_(figures) {}

    /// All parts are looked at: a fault in the second is one where the first decides too.
    bool any(Text text) {
        bool holds = false;
        for (const Text part : split(text, "||")) holds |= all(part);
        return holds;
    }
    [[nodiscard]] const std::set<std::string>& used() const { return used_; }

  private:
    bool all(Text text) {
        bool holds = true;
        for (const Text part : split(text, "&&")) holds &= one(trimmed(part));
        return holds;
    }

    bool one(Text text) {
        if (is_in_parentheses(text)) return any(text.substr(1, text.size() - 2));
        const auto comparison = comparison_in(text);
        if (!comparison) throw BadStatement(in_quotes(text) + " is no comparison of two values");
        uses_ = finite_ = 0;
        const double left = value(comparison->left), right = value(comparison->right);
        if (uses_ == 0) throw BadStatement(in_quotes(text) + " compares no figure");
        if (std::isfinite(left) && std::isfinite(right)) return comparison->sign->holds(left, right);
        if (finite_ < uses_) return false;
        throw BadStatement(in_quotes(text) + " is not finite: it compares " + number_text(left) + " and " +
                           number_text(right));
    }

    /// muParser knows numbers, names, arithmetic and functions, and can do nothing but compute.
    double value(Text text) {
        mu::Parser parser;
        parser.DefineNameChars(figure_letters);
        for (auto& [name, figure] : figures_) parser.DefineVar(name, &figure);
        parser.SetExpr(std::string(text));
        const double result = parser.Eval();
        if (parser.GetNumResults() != 1) throw BadStatement(in_quotes(text) + " is more than one value");
        for (const auto& [name, figure] : parser.GetUsedVar()) {
            used_.insert(name);
            ++uses_;
            finite_ += std::isfinite(*figure);
        }
        return result;
    }

    Figures figures_;  ///< a copy, since muParser takes no constants
    std::set<std::string> used_;
    int uses_ = 0, finite_ = 0;  ///< figures of the comparison at hand
};

/// muParser would assign.
bool has_assignment(Text text) {
    for (std::size_t i = 0; i < text.size(); ++i) {
        const Sign* sign = sign_at(text, i);
        if (sign == nullptr && text[i] == '=') return true;
        if (sign != nullptr) i += sign->text.size() - 1;
    }
    return false;
}

}  // namespace

Judgement judge(const std::string& statement, const Figures& figures) {
    if (has_assignment(statement)) throw BadStatement("= is no comparison; == is");
    if (statement.find('?') != std::string::npos) throw BadStatement("? : is no comparison");
    Judge judge(figures);
    try {
        const bool holds = judge.any(statement);
        return {holds, judge.used()};
    } catch (const mu::ParserError& error) {
        throw BadStatement(error.GetMsg());
    }
}

}  // namespace flipside::lab

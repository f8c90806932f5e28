#include "app/window/claim_words.hpp"

#include <algorithm>
#include <utility>

#include "app/window/words.hpp"

namespace flipside::app {

namespace {

using Words = std::pair<std::string_view, std::string_view>;

constexpr std::string_view name_letters = lab::figure_letters;
constexpr std::string_view figures_letters = "0123456789";

std::vector<std::string> parts_of(std::string_view text, std::string_view between) {
    std::vector<std::string> parts;
    for (std::size_t end = 0; end != std::string_view::npos;) {
        end = text.find(between);
        parts.emplace_back(text.substr(0, end));
        if (end != std::string_view::npos) text.remove_prefix(end + between.size());
    }
    return parts;
}

/// "x0" is of ball 0.
std::string figure_in_words(std::string_view name) {
    constexpr Words of_ball[] = {{"x", "x of ball "},
                                 {"y", "y of ball "},
                                 {"vx", "velocity along x of ball "},
                                 {"vy", "velocity along y of ball "},
                                 {"r", "radius of ball "}};
    const std::string_view stem = name.substr(0, name.find_last_not_of(figures_letters) + 1);
    for (const auto& [letters, words] : of_ball)
        if (stem == letters && stem.size() < name.size())
            return std::string(words) + std::string(name.substr(stem.size()));
    constexpr Words whole[] = {{"pair_tests", "box tests"},
                               {"pair_tests_per_step", "box tests per step"},
                               {"narrow_tests", "full tests"},
                               {"narrow_tests_per_step", "full tests per step"},
                               {"lost", "balls lost"},
                               {"strays", "balls that got out"},
                               {"asleep", "balls asleep"},
                               {"deepest", "deepest overlap"},
                               {"highest", "greatest height"},
                               {"energy_first", "energy at first"},
                               {"energy_last", "energy at last"},
                               {"error_radii", "distance from the reference in radii"},
                               {"touching_first", "touches at first"},
                               {"touching_differs", "touches that differ"},
                               {"read_out_off", "change by the read-out"},
                               {"separation_off", "error of the distances"},
                               {"test_items", "pairs tested"},
                               {"axis_items", "axes tested"}};
    for (const auto& [file, words] : whole)
        if (name == file) return std::string(words);
    constexpr std::string_view moves = "moves_in_";
    if (name.starts_with(moves)) return "balls moved in " + with_spaces(name.substr(moves.size()));
    return with_spaces(name);
}

/// Of a run, or of what computes.
std::string name_in_words(std::string_view name, bool one_run) {
    const std::size_t point = name.find('.');
    if (point == std::string_view::npos) return std::string(name);
    const std::string words = figure_in_words(name.substr(point + 1));
    return one_run ? words : words + " (" + with_spaces(name.substr(0, point)) + ")";
}

/// Takes a number from the front of a text: "1e-12" is 10⁻¹².
std::string take_number(std::string_view& text) {
    const std::size_t size = std::min(text.find_first_not_of("0123456789."), text.size());
    std::string number(text.substr(0, size));
    text.remove_prefix(size);
    if (text.empty() || text.front() != 'e') return number;
    text.remove_prefix(1);
    const bool small = text.starts_with('-');
    if (small || text.starts_with('+')) text.remove_prefix(1);
    const std::size_t digits = std::min(text.find_first_not_of(figures_letters), text.size());
    const int exponent = std::stoi("0" + std::string(text.substr(0, std::min<std::size_t>(digits, 4))));
    text.remove_prefix(digits);
    return (number == "1" ? "" : number + "·") + power_of_ten(small ? -exponent : exponent);
}

std::string take_sign(std::string_view& text) {
    constexpr Words signs[] = {{"==", "="},  {"!=", "≠"}, {"<=", "≤"},   {">=", "≥"}, {"&&", "and"},
                               {"||", "or"}, {"^2", "²"}, {" ^ 2", "²"}, {"*", "×"},  {"-", "−"}};
    for (const auto& [sign, words] : signs)
        if (text.starts_with(sign)) {
            text.remove_prefix(sign.size());
            return std::string(words);
        }
    std::string other(text.substr(0, 1));
    text.remove_prefix(1);
    return other;
}

}  // namespace

std::string claim_in_words(std::string_view statement, bool one_run) {
    std::string words;
    std::vector<std::string> ends;  // of the brackets that are open
    while (!statement.empty()) {
        const bool absolute = statement.starts_with("abs(");
        if (absolute || statement.front() == '(') {
            ends.emplace_back(absolute ? "|" : ")");
            words += absolute ? "|" : "(";
            statement.remove_prefix(absolute ? 4 : 1);
        } else if (statement.front() == ')' && !ends.empty()) {
            words += ends.back();
            ends.pop_back();
            statement.remove_prefix(1);
        } else if (figures_letters.find(statement.front()) != std::string_view::npos) {
            words += take_number(statement);
        } else if (name_letters.find(statement.front()) != std::string_view::npos) {
            const std::size_t size = std::min(statement.find_first_not_of(name_letters), statement.size());
            words += name_in_words(statement.substr(0, size), one_run);
            statement.remove_prefix(size);
        } else {
            words += take_sign(statement);
        }
    }
    return words;
}

std::vector<std::string> measured_in_words(const lab::Verified& one, bool one_run) {
    const std::vector<std::string> said = parts_of(claim_in_words(one.statement, one_run), " and ");
    std::vector<std::string> measured;
    for (const std::string& figure : one.measured) {
        std::string words = claim_in_words(figure, one_run);
        if (std::ranges::find(said, words) == said.end()) measured.push_back(std::move(words));
    }
    return measured;
}

}  // namespace flipside::app

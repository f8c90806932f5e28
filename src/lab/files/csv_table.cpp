#include "lab/files/csv_table.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "lab/files/plain_name.hpp"
#include "world/input_error.hpp"
#include "world/json_file.hpp"

namespace flipside::lab {

namespace {

/// Takes fields off a text, one after the other.
class Fields {
  public:
    Fields(const std::filesystem::path& file, std::string text) : file_(file), text_(std::move(text)) {}

    [[nodiscard]] bool at_end() const { return at_ == text_.size(); }
    [[nodiscard]] std::size_t line() const { return line_; }

    /// The fields up to the end of this line.
    std::vector<std::string> record() {
        std::vector<std::string> fields;
        do fields.push_back(field());
        while (take(','));
        take('\r');
        if (!take('\n') && !at_end())
            throw InputError(file_.string() + ": line " + std::to_string(line_) +
                             ": a field goes on after its closing quote");
        ++line_;
        return fields;
    }

  private:
    bool take(char wanted) {
        if (at_end() || text_[at_] != wanted) return false;
        ++at_;
        return true;
    }
    std::string field() {
        if (take('"')) return quoted();
        const std::size_t end = std::min(text_.find_first_of(",\r\n", at_), text_.size());
        std::string found = text_.substr(at_, end - at_);
        at_ = end;
        return found;
    }
    std::string quoted() {
        const std::size_t first_line = line_;
        std::string found;
        while (!at_end()) {
            const char c = text_[at_++];
            if (c == '"' && !take('"')) return found;
            if (c == '\n') ++line_;
            found += c;
        }
        throw InputError(file_.string() + ": line " + std::to_string(first_line) +
                         ": a quoted field has no end");
    }

    const std::filesystem::path& file_;
    std::string text_;
    std::size_t at_ = 0, line_ = 1;
};

template <class Number>
bool parse(const std::string& text, Number& value) {
    const char* const end = text.data() + text.size();
    const auto [stopped, error] = std::from_chars(text.data(), end, value);
    return error == std::errc{} && stopped == end;
}

}  // namespace

CsvTable::CsvTable(const std::filesystem::path& file) : CsvTable(file, read_file(file)) {}

CsvTable::CsvTable(const std::filesystem::path& file, std::string text) : file_(file) {
    Fields fields(file, std::move(text));
    columns_ = fields.record();
    while (!fields.at_end()) {
        lines_.push_back(fields.line());
        rows_.push_back(fields.record());
        if (rows_.back().size() != columns_.size())
            throw InputError(file.string() + ": line " + std::to_string(lines_.back()) + ": has " +
                             std::to_string(rows_.back().size()) + " fields; its header names " +
                             std::to_string(columns_.size()));
    }
}

bool CsvTable::has(std::string_view column) const {
    return std::ranges::find(columns_, column) != columns_.end();
}

std::size_t CsvTable::index(std::string_view column) const {
    const auto at = std::ranges::find(columns_, column);
    if (at == columns_.end())
        throw InputError(file_.string() + ": line 1: has no column '" + std::string(column) + "'");
    return static_cast<std::size_t>(at - columns_.begin());
}

void CsvTable::refuse(std::size_t row, std::string_view column, std::string_view wanted) const {
    constexpr std::size_t enough = 60;  // of what may be a megabyte
    std::string found = field(row, column).substr(0, enough + 1);
    if (found.size() > enough) found.replace(enough, 1, "...");
    throw InputError(file_.string() + ": line " + std::to_string(lines_[row]) + ": " + std::string(column) +
                     " '" + found + "' is not " + std::string(wanted));
}

const std::string& CsvTable::field(std::size_t row, std::string_view column) const {
    const std::size_t at = index(column);
    if (row >= rows_.size()) throw InputError(file_.string() + ": has no row " + std::to_string(row + 1));
    return rows_[row][at];
}

std::string CsvTable::text(std::size_t row, std::string_view column) const {
    const std::string& found = field(row, column);
    return found.substr(found.starts_with('\'') ? 1 : 0);
}

const std::string& CsvTable::name(std::size_t row, std::string_view column) const {
    const std::string& found = field(row, column);
    if (!is_plain_name(found)) refuse(row, column, "a name; allowed are " + std::string(plain_name_rule));
    return found;
}

const std::string& CsvTable::one_of(std::size_t row, std::string_view column,
                                    std::span<const std::string_view> allowed) const {
    const std::string& found = field(row, column);
    if (std::ranges::find(allowed, found) != allowed.end()) return found;
    std::string known;
    for (const std::string_view word : allowed)
        known += (known.empty() ? "" : ", ") + ("'" + std::string(word) + "'");
    refuse(row, column, "one of " + known);
}

double CsvTable::number(std::size_t row, std::string_view column) const {
    double value = 0;
    if (!parse(field(row, column), value)) refuse(row, column, "a number");
    return value;
}

double CsvTable::finite(std::size_t row, std::string_view column) const {
    const double value = number(row, column);
    if (!std::isfinite(value)) refuse(row, column, "finite");
    return value;
}

std::uint64_t CsvTable::count(std::size_t row, std::string_view column) const {
    std::uint64_t value = 0;
    if (!parse(field(row, column), value)) refuse(row, column, "a whole number");
    return value;
}

}  // namespace flipside::lab

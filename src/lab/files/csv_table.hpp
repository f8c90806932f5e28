#pragma once
/// A CSV file with a header line, read back: fields by row and name of column. What is wrong with a file is
/// an InputError that names the file, the line and the column.

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace flipside::lab {

class CsvTable {
  public:
    /// Reads the whole file. Every line must have as many fields as the header; quotes as in RFC 4180.
    explicit CsvTable(const std::filesystem::path& file);
    /// The same of a text that is here already.
    CsvTable(const std::filesystem::path& file, std::string text);

    [[nodiscard]] std::size_t rows() const { return rows_.size(); }
    [[nodiscard]] const std::vector<std::string>& columns() const { return columns_; }
    [[nodiscard]] bool has(std::string_view column) const;
    /// All that follow throw where there is no such row or column.
    /// Without the ' that CsvRow puts before what begins like a formula.
    [[nodiscard]] std::string text(std::size_t row, std::string_view column) const;
    /// Throws for what is no plain name (plain_name.hpp).
    [[nodiscard]] const std::string& name(std::size_t row, std::string_view column) const;
    /// Throws for what is none of the words allowed.
    [[nodiscard]] const std::string& one_of(std::size_t row, std::string_view column,
                                            std::span<const std::string_view> allowed) const;
    /// Throws for what is no number; "inf" and "nan" are some.
    [[nodiscard]] double number(std::size_t row, std::string_view column) const;
    /// Throws for "inf" and "nan" too.
    [[nodiscard]] double finite(std::size_t row, std::string_view column) const;
    /// Throws for what is no whole number ≥ 0.
    [[nodiscard]] std::uint64_t count(std::size_t row, std::string_view column) const;
    /// Throws InputError: what stands there is not what is wanted, "a number".
    [[noreturn]] void refuse(std::size_t row, std::string_view column, std::string_view wanted) const;

  private:
    [[nodiscard]] std::size_t index(std::string_view column) const;
    /// As it stands in the file.
    [[nodiscard]] const std::string& field(std::size_t row, std::string_view column) const;

    std::filesystem::path file_;
    std::vector<std::string> columns_;
    std::vector<std::vector<std::string>> rows_;
    std::vector<std::size_t> lines_;  ///< of each row, from 1
};

}  // namespace flipside::lab

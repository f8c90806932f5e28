#pragma once
/// Components of the page: elements, tables, figures.

#include <string>
#include <string_view>

#include "lab/report/page.hpp"

namespace flipside::lab::report {

/// <NAME ATTRIBUTES>escaped text</NAME>
[[nodiscard]] std::string element(const std::string& name, std::string_view text,
                                  const std::string& attributes = "");
[[nodiscard]] std::string link_to(const std::string& id, std::string_view text);

/// A table of more rows than this is folded away.
inline constexpr std::size_t most_open_rows = 12;
[[nodiscard]] std::string table_html(const Table& table);

/// The figure with its key, whose names show and hide what they name, and its points as a table.
[[nodiscard]] std::string figure_html(const Figure& figure, const std::string& svg);
/// Styles by which the keys of all figures work: the class of a series' marks, and of its tick in the key.
[[nodiscard]] std::string series_class(std::size_t series);
[[nodiscard]] std::string key_style(std::size_t most_series);

}  // namespace flipside::lab::report

#include "lab/report/page.hpp"

#include <cmath>

#include "lab/report/markup.hpp"
#include "lab/report/page_style.hpp"

namespace flipside::lab::report {

namespace {

/// <NAME ATTRIBUTES>escaped text</NAME>
std::string element(const std::string& name, std::string_view text, const std::string& attributes = "") {
    return "<" + name + (attributes.empty() ? "" : " ") + attributes + ">" + escape(text) + "</" + name + ">";
}

std::string with_id(const std::string& id) {
    return "id=\"" + escape(id) + "\"";
}

std::string cell_html(const Table::Cell& cell, bool names_row) {
    if (names_row) return element("th", cell.text, "scope=\"row\"");
    std::string classes = cell.is_number ? "number" : "";
    if (!cell.kind.empty()) classes += (classes.empty() ? "" : " ") + escape(cell.kind);
    return element("td", cell.text, classes.empty() ? "" : "class=\"" + classes + "\"");
}

std::string table_html(const Table& table) {
    std::string html = "<div class=\"wide\" tabindex=\"0\" role=\"region\" aria-label=\"" +
                       escape(table.title) + "\">\n<table>" + element("caption", table.title) +
                       "\n<thead><tr>";
    for (const std::string& column : table.columns) html += element("th", column, "scope=\"col\"");
    html += "</tr></thead>\n<tbody>\n";
    for (const auto& row : table.rows) {
        html += "<tr>";
        for (const Table::Cell& cell : row) html += cell_html(cell, &cell == row.data());
        html += "</tr>\n";
    }
    return html + "</tbody></table></div>\n";
}

std::string number_text(double value) {
    return std::isfinite(value) ? short_number(value) : "–";
}

/// For those who cannot see the figure, or want its numbers.
std::string points_html(const Figure& figure) {
    Table table{
        figure.id + "-points", figure.title, {"Series", "Point", figure.x.label, figure.y.label}, {}, ""};
    for (const auto& [series, point] : rows_of(figure))
        table.rows.push_back({{series->name},
                              {point->says},
                              {number_text(point->x), true},
                              {number_text(point->y), true, std::isfinite(point->y) ? "" : "bad"}});
    return "<details><summary>The " + std::to_string(table.rows.size()) + " points as a table</summary>\n" +
           table_html(table) + "</details>\n";
}

std::string figure_html(const Figure& figure, const std::string& svg) {
    const std::string csv = escape("data/figure-" + figure.id + ".csv"),
                      picture = escape("figures/" + figure.id);
    return "<figure " + with_id(figure.id) + ">\n" + element("h3", figure.title) +
           "\n<div class=\"wide\" tabindex=\"0\" role=\"region\" aria-label=\"" + escape(figure.title) +
           "\">\n" + svg + "</div>\n<figcaption>" + element("p", figure.reading) +
           "\n<p>Beside this page: " + element("a", "points (CSV)", "href=\"" + csv + "\"") + ", " +
           element("a", "picture (PNG)", "href=\"" + picture + ".png\"") + ", " +
           element("a", "picture (SVG)", "href=\"" + picture + ".svg\"") + "</p></figcaption>\n" +
           points_html(figure) + "</figure>\n";
}

std::string chapter_html(const PageChapter& chapter) {
    std::string html = "<section " + with_id("chapter-" + chapter.id) + ">\n" + element("h2", chapter.title) +
                       "\n" + element("p", chapter.intro) + "\n";
    for (std::size_t i = 0; i < chapter.content.figures.size(); ++i)
        html += figure_html(chapter.content.figures[i], chapter.svgs[i]);
    for (const Table& table : chapter.content.tables)
        html += "<div " + with_id(table.id) + ">\n" + table_html(table) + element("p", table.reading) +
                "</div>\n";
    return html + "</section>\n";
}

}  // namespace

std::string html_of(const Page& page) {
    std::string html =
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
        "<link rel=\"icon\" href=\"data:,\">\n" +
        element("title", page.title) + "\n<style>" + std::string(page_style) +
        "</style>\n</head>\n<body>\n<header>" + element("h1", page.title) + "\n" + element("p", page.intro) +
        "\n<nav aria-label=\"Chapters\"><ul>\n";
    for (const PageChapter& chapter : page.chapters)
        html +=
            "<li>" + element("a", chapter.title, "href=\"#chapter-" + escape(chapter.id) + "\"") + "</li>\n";
    html += "</ul></nav></header>\n<main>\n";
    for (const PageChapter& chapter : page.chapters) html += chapter_html(chapter);
    html += "</main>\n<footer>" + element("h2", "How this was made") + "\n<dl>\n";
    for (const auto& [name, value] : page.facts) html += element("dt", name) + element("dd", value) + "\n";
    return html + "</dl></footer>\n<div id=\"tip\" role=\"tooltip\" hidden></div>\n<script>" +
           std::string(page_script) + "</script>\n</body>\n</html>\n";
}

}  // namespace flipside::lab::report

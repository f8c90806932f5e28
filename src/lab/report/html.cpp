#include "lab/report/html.hpp"

#include <cmath>

#include "lab/report/markup.hpp"

namespace flipside::lab::report {

namespace {

std::string cell_html(const Table::Cell& cell, bool names_row) {
    if (names_row) return element("th", cell.text, "scope=\"row\"");
    std::string classes = cell.is_number ? "number" : "";
    if (!cell.kind.empty()) classes += (classes.empty() ? "" : " ") + escape(cell.kind);
    return element("td", cell.text, classes.empty() ? "" : "class=\"" + classes + "\"");
}

std::string number_text(double value) {
    return std::isfinite(value) ? short_number(value) : "–";
}

std::string scrolling_table(const Table& table) {
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

/// The numbers of the figure, also for readers who cannot see it.
std::string points_html(const Figure& figure) {
    Table table{
        figure.id + "-points", figure.title, {"Series", "Point", figure.x.label, figure.y.label}, {}, ""};
    for (const auto& [series, point] : rows_of(figure))
        table.rows.push_back({{series->name},
                              {point->says},
                              {number_text(point->x), true},
                              {number_text(point->y), true, std::isfinite(point->y) ? "" : "bad"}});
    return "<details><summary>The " + std::to_string(table.rows.size()) + " points as a table</summary>\n" +
           scrolling_table(table) + "</details>\n";
}

/// The marker as gnuplot draws it, about (18, 6).
std::string marker_svg(int type) {
    const bool hollow = type % 2 == 0;
    const std::string fill = hollow && type > 3 ? "fill=\"none\"" : "fill=\"currentColor\"";
    std::string path;
    switch (type) {
        case 1:
            path = "M14 6h8M18 2v8";
            break;
        case 2:
            path = "M15 3l6 6M15 9l6-6";
            break;
        case 4:
        case 5:
            path = "M14.5 2.5h7v7h-7z";
            break;
        case 6:
        case 7:
            path = "M14 6a4 4 0 1 0 8 0a4 4 0 1 0-8 0z";
            break;
        case 8:
        case 9:
            path = "M18 1.5l4.5 8h-9z";
            break;
        case 10:
        case 11:
            path = "M18 10.5l4.5-8h-9z";
            break;
        default:
            path = "M18 1l4.5 5l-4.5 5l-4.5-5z";
    }
    return "<path d=\"" + path + "\" " + fill + " stroke=\"currentColor\" stroke-width=\"1.4\"/>";
}

std::string swatch(const Series& series) {
    constexpr const char* dashes[] = {"", "6 3", "2 3", "7 3 2 3", "7 2 2 2 2 2"};
    std::string svg = "<svg class=\"swatch\" aria-hidden=\"true\" viewBox=\"0 0 36 12\" style=\"color:" +
                      escape(series.colour) + "\">";
    const auto dash = static_cast<std::size_t>(series.dash - 1) % std::size(dashes);
    if (series.joined)
        svg += std::string(
                   "<path d=\"M0 6h36\" stroke=\"currentColor\" stroke-width=\"2\" "
                   "stroke-dasharray=\"") +
               dashes[dash] + "\"/>";
    return svg + marker_svg(series.marker) + "</svg>";
}

std::string key_html(const Figure& figure) {
    std::string shown, others;
    std::size_t count = 0;
    for (std::size_t i = 0; i < figure.series.size(); ++i) {
        const Series& series = figure.series[i];
        (series.shown ? shown : others) += "<label><input type=\"checkbox\" autocomplete=\"off\" class=\"k" +
                                           std::to_string(i) + "\"" + (series.shown ? " checked" : "") + ">" +
                                           swatch(series) + element("span", series.name) + "</label>\n";
        count += series.shown ? 0 : 1;
    }
    const std::string key = "<div class=\"key\" role=\"group\" aria-label=\"What is shown\">\n";
    if (count == 0) return key + shown + "</div>\n";
    const std::string number = std::to_string(count);
    return key + shown + "<label><input type=\"checkbox\" autocomplete=\"off\" class=\"all\">all " + number +
           " others</label></div>\n<details><summary>One of the " + number + " others</summary>" + key +
           others + "</div></details>\n";
}

}  // namespace

std::string element(const std::string& name, std::string_view text, const std::string& attributes) {
    return "<" + name + (attributes.empty() ? "" : " ") + attributes + ">" + escape(text) + "</" + name + ">";
}

std::string link_to(const std::string& id, std::string_view text) {
    return element("a", text, "href=\"#" + escape(id) + "\"");
}

std::string table_html(const Table& table) {
    std::string html = scrolling_table(table);
    if (table.rows.size() <= most_open_rows) return html;
    return "<details>" +
           element("summary", table.title + ": " + std::to_string(table.rows.size()) + " rows") + "\n" +
           html + "</details>\n";
}

std::string series_class(std::size_t series) {
    return "s" + std::to_string(series);
}

std::string key_style(std::size_t most_series) {
    std::string style;
    for (std::size_t i = 0; i < most_series; ++i)
        style += "figure:has(.k" + std::to_string(i) + ":not(:checked)):not(:has(.all:checked)) ." +
                 series_class(i) + "{display:none}\n";
    return style;
}

std::string figure_html(const Figure& figure, const std::string& svg) {
    const std::string csv = escape("data/figure-" + figure.id + ".csv"),
                      picture = escape("figures/" + figure.id);
    const bool names = figure.y.things.empty();
    return "<figure id=\"" + escape(figure.id) + "\">\n" + element("h3", figure.title) + "\n" +
           (names ? element("p", "↑ " + figure.y.label, "class=\"axis\"") : "") + svg +
           element("p", figure.x.label + " →", "class=\"axis across\"") + "\n" + key_html(figure) +
           "<figcaption>" + element("p", figure.reading) +
           "\n<p>Beside this page: " + element("a", "points (CSV)", "href=\"" + csv + "\"") + ", " +
           element("a", "picture (PNG)", "href=\"" + picture + ".png\"") + "</p></figcaption>\n" +
           points_html(figure) + "</figure>\n";
}

}  // namespace flipside::lab::report

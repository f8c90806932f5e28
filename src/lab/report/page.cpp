#include "lab/report/page.hpp"

#include <algorithm>

#include "lab/report/front_page.hpp"
#include "lab/report/html.hpp"
#include "lab/report/markup.hpp"
#include "lab/report/page_style.hpp"

namespace flipside::lab::report {

namespace {

std::string chapter_html(const PageChapter& chapter) {
    std::string html = "<section id=\"chapter-" + escape(chapter.id) + "\">\n" +
                       element("h2", chapter.title) + "\n" + element("p", chapter.intro) + "\n";
    std::string figures;
    for (std::size_t i = 0; i < chapter.content.figures.size(); ++i) {
        const Figure& figure = chapter.content.figures[i];
        if (figure.on_front)
            html += "<p>On the front page: " + link_to(figure.id, figure.title) + "</p>\n";
        else
            figures += figure_html(figure, chapter.svgs[i]);
    }
    if (!figures.empty()) html += "<div class=\"figures\">\n" + figures + "</div>\n";
    for (const Table& table : chapter.content.tables)
        html += "<div id=\"" + escape(table.id) + "\">\n" + table_html(table) +
                element("p", table.reading, "class=\"reading\"") + "</div>\n";
    return html + "</section>\n";
}

std::size_t most_series(const Page& page) {
    std::size_t most = 0;
    for (const PageChapter& chapter : page.chapters)
        for (const Figure& figure : chapter.content.figures) most = std::max(most, figure.series.size());
    return most;
}

}  // namespace

std::string html_of(const Page& page) {
    std::string html =
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
        "<link rel=\"icon\" href=\"data:,\">\n" +
        element("title", page.title) + "\n<style>" + std::string(page_style) + key_style(most_series(page)) +
        "</style>\n</head>\n<body>\n" + front_html(page) + "<main>\n";
    for (const PageChapter& chapter : page.chapters) html += chapter_html(chapter);
    html += "</main>\n<footer>" + element("h2", "How this was made") + "\n<dl>\n";
    for (const auto& [name, value] : page.facts) html += element("dt", name) + element("dd", value) + "\n";
    return html + "</dl></footer>\n<div id=\"tip\" role=\"tooltip\" hidden></div>\n<script>" +
           std::string(page_script) + "</script>\n</body>\n</html>\n";
}

}  // namespace flipside::lab::report

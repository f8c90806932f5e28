#include "lab/report/front_page.hpp"

#include <cctype>

#include "lab/report/html.hpp"
#include "lab/report/markup.hpp"

namespace flipside::lab::report {

namespace {

/// No line ends within a number such as 4e-14.
std::string unbroken(std::string text) {
    for (std::size_t at = text.find("e-"); at != std::string::npos; at = text.find("e-", at + 1))
        if (at > 0 && std::isdigit(static_cast<unsigned char>(text[at - 1])) != 0)
            text.replace(at + 1, 1, "\u2011");
    return text;
}

/// On a narrow screen a row becomes a card, and each cell needs its column's name.
std::string pick_cell(const char* column, const std::string& text) {
    return element("td", unbroken(text), std::string("data-column=\"") + column + "\"");
}

std::string picks_html(const Page& page) {
    std::string rows;
    for (const PageChapter& chapter : page.chapters)
        for (const Pick& pick : chapter.content.picks)
            rows += "<tr>" + element("th", pick.scene, "scope=\"row\"") +
                    "<td class=\"take\" style=\"--of:" + escape(pick.colour) + "\">" + escape(pick.take) +
                    "</td>" + pick_cell("Off by (radii)", pick.error) +
                    pick_cell("Costs a second", pick.cost) + pick_cell("Else", pick.instead) + "</tr>\n";
    if (rows.empty()) return "";
    return "<section id=\"picks\">\n" + element("h2", "Pick this setting") +
           "\n<table class=\"picks\"><thead><tr><th scope=\"col\">Kind of scene</th><th "
           "scope=\"col\">Take</th><th scope=\"col\">Off by, radii (95 % sure)</th><th "
           "scope=\"col\">Costs a second</th><th scope=\"col\">The best of another "
           "engine</th></tr></thead>\n<tbody>\n" +
           rows + "</tbody></table>\n" + element("p", page.pick_rule, "class=\"reading\"") + "</section>\n";
}

std::string findings_html(const Page& page) {
    std::string items;
    for (const PageChapter& chapter : page.chapters)
        for (const std::string& finding : chapter.content.findings)
            items +=
                "<li>" + escape(finding) + " " + link_to("chapter-" + chapter.id, chapter.title) + "</li>\n";
    if (items.empty()) return "";
    return "<section id=\"findings\">\n" + element("h2", "What came out") + "\n<ol>\n" + items +
           "</ol></section>\n";
}

std::string key_figures_html(const Page& page) {
    std::string figures;
    for (const PageChapter& chapter : page.chapters)
        for (std::size_t i = 0; i < chapter.content.figures.size(); ++i)
            if (chapter.content.figures[i].on_front)
                figures += figure_html(chapter.content.figures[i], chapter.svgs[i]);
    if (figures.empty()) return "";
    return "<section id=\"key-figures\">\n" + element("h2", "Key figures") + "\n<div class=\"figures\">\n" +
           figures + "</div></section>\n";
}

std::string scenes_html(const Page& page) {
    if (page.scenes.empty()) return "";
    std::string html =
        "<section id=\"scenes\">\n" + element("h2", "The scenes") + "\n<div class=\"scenes\">\n";
    for (const Picture& scene : page.scenes)
        html += "<div class=\"scene\">" + scene.svg + "<p><strong>" + escape(scene.name) + "</strong> " +
                escape(scene.about) + "</p></div>\n";
    return html + "</div></section>\n";
}

}  // namespace

std::string front_html(const Page& page) {
    std::string html = "<header>" + element("h1", page.title) + "\n";
    if (!page.warning.empty()) html += element("p", page.warning, "class=\"warning\" role=\"note\"") + "\n";
    html += element("p", page.intro) + "</header>\n" + picks_html(page) + findings_html(page) +
            key_figures_html(page) + scenes_html(page) + "<section id=\"run\">\n" +
            element("h2", "What was run") + "\n" + element("p", page.was_run) + "\n<p>To cite it: <q>" +
            escape(page.cite) + "</q></p>\n</section>\n<nav aria-label=\"Chapters\">" +
            element("h2", "Chapters") + "<ul>\n";
    for (const PageChapter& chapter : page.chapters)
        html += "<li>" + link_to("chapter-" + chapter.id, chapter.title) + "</li>\n";
    return html + "</ul></nav>\n";
}

}  // namespace flipside::lab::report

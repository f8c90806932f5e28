#pragma once
/// The report as one HTML page that needs nothing but itself: figures, tables and words.

#include <string>
#include <vector>

#include "lab/report/figure.hpp"

namespace flipside::lab::report {

struct Table {
    struct Cell {
        std::string text;
        bool is_number = false;  ///< set to the right
        std::string kind{};      ///< "good", "bad" or "": how it is marked beside its words
    };
    std::string id, title;
    std::vector<std::string> columns;  ///< the first names the row
    std::vector<std::vector<Cell>> rows;
    std::string reading;  ///< how to read it
};

/// What to take for a kind of scene: a row of the front page.
struct Pick {
    std::string scene;    ///< "pinball, 8 balls"
    std::string take;     ///< engine, settings and step
    std::string colour;   ///< of the engine
    std::string error;    ///< how far off that is, and how sure this is
    std::string cost;     ///< how dear
    std::string instead;  ///< the best of the other engines, beside it
};

/// What a chapter shows. Any list may be empty.
struct Content {
    std::vector<Figure> figures;
    std::vector<Table> tables;
    std::vector<std::string> findings{};  ///< a sentence each for the front page
    std::vector<Pick> picks{};            ///< for the front page
};

struct PageChapter {
    std::string id, title, intro;
    Content content;
    std::vector<std::string> svgs;  ///< one per figure, as inline_svg gives them
};

/// A scene as it looks.
struct Picture {
    std::string name, about;
    std::string svg;
};

struct Page {
    std::string title, intro;
    std::string warning;    ///< "" or what must be known before anything is believed
    std::string pick_rule;  ///< how the picks were made
    std::string was_run;    ///< what was run, and how long
    std::string cite;       ///< as what to cite it
    std::vector<Picture> scenes;
    std::vector<PageChapter> chapters;
    std::vector<std::pair<std::string, std::string>> facts;  ///< the footer: name, value
};

[[nodiscard]] std::string html_of(const Page& page);

}  // namespace flipside::lab::report

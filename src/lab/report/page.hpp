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

/// What a chapter shows. Either list may be empty.
struct Content {
    std::vector<Figure> figures;
    std::vector<Table> tables;
};

struct PageChapter {
    std::string id, title, intro;
    Content content;
    std::vector<std::string> svgs;  ///< one per figure, as inline_svg gives them
};

struct Page {
    std::string title, intro;
    std::vector<PageChapter> chapters;
    std::vector<std::pair<std::string, std::string>> facts;  ///< the footer: name, value
};

[[nodiscard]] std::string html_of(const Page& page);

}  // namespace flipside::lab::report

#pragma once
/// What is known of a ball or part, and of its last impact, on every contender side by side: as words. Knows
/// no screen.

#include <optional>
#include <string>
#include <vector>

#include "app/window/stage.hpp"
#include "lab/comparison/impact_verdict.hpp"

namespace flipside::app {

struct Card {
    struct Row {
        std::string label;
        std::vector<std::string> cells;  ///< one per run; of several lines some; "" where there is nothing
        std::string_view meaning;
    };
    Other subject;  ///< whose it is
    std::string title;
    std::string about;
    std::vector<Row> rows;
};

/// Of that ball or part; of nothing, the last impact alone, of the ball that last had one. Nothing of what is
/// not in the scene.
[[nodiscard]] std::optional<Card> card_of(const Stage& stage, std::optional<Other> subject);

}  // namespace flipside::app

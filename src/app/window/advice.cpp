#include "app/window/advice.hpp"

namespace flipside::app {

namespace {

/// Of the runs that go on, those whose game is over or those whose game is not.
std::string names_of(std::span<const Run> runs, bool over) {
    std::string names;
    for (const Run& run : runs)
        if (run.session().scene().rules && !run.halt() && run.session().game().over() == over)
            names += (names.empty() ? "" : ", ") + run.name();
    return names;
}

}  // namespace

std::string advice(std::span<const Run> shown, const Stage& stage) {
    const Run& front = shown.size() == 1 ? shown.front() : stage.lead();
    const std::string over = names_of(shown, true), playing = names_of(stage.runs(), false);
    if (!over.empty() && playing.empty()) return "Game over: R to play again";
    if (!over.empty() && shown.size() == 1)
        return "Game over here, " + playing + " still in play: R starts all again";
    if (!over.empty()) return "Game over for " + over + ", " + playing + " still in play: R starts all again";
    if (front.session().game().tilted()) return "Tilt";
    if (!front.session().world().balls().empty()) return "";
    if (!front.session().scene().launcher) return "No balls: R to restart";
    return front.session().world().save().launches.empty() ? "Space to launch" : "";
}

}  // namespace flipside::app

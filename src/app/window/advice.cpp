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

/// Which ball is to be launched.
CaptionWords launch_in_words(const lab::Session& session) {
    if (!session.scene().rules) return {"Space to launch", ""};
    const lab::Turns& turns = session.game().turns();
    return {"Ball " + std::to_string(turns.number()) + " of " + std::to_string(turns.turns()),
            "hold Space, and let go"};
}

}  // namespace

std::optional<CaptionWords> advice(std::span<const Run> shown, const Stage& stage) {
    const Run& front = shown.size() == 1 ? shown.front() : stage.lead();
    const std::string over = names_of(shown, true), playing = names_of(stage.runs(), false);
    if (!over.empty() && playing.empty()) return std::nullopt;
    const std::string goes_on = playing + (playing.find(',') == std::string::npos ? " plays on" : " play on");
    if (!over.empty() && shown.size() == 1) return CaptionWords{"Game over here", goes_on};
    if (!over.empty()) return CaptionWords{"Game over for " + over, goes_on};
    const lab::Session& session = front.session();
    if (!session.world().balls().empty()) return std::nullopt;
    if (!session.scene().launcher)
        return CaptionWords{"No balls",
                            session.scene().balls.empty() ? "Ctrl and a click add one" : "R to restart"};
    if (!session.game().permits(control::Launch{}, {}) || !session.world().save().launches.empty())
        return std::nullopt;
    return launch_in_words(session);
}

}  // namespace flipside::app

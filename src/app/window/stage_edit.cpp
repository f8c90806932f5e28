/// What a hand does to the balls of a stage.

#include <algorithm>

#include "app/window/stage.hpp"

namespace flipside::app {

bool Stage::edit(const lab::BallEdit& edit) {
    lab::BallEdit everywhere = edit;
    if (auto* add = std::get_if<lab::edit::Add>(&everywhere))
        for (const Run& run : runs_)
            add->ball.number = std::max(add->ball.number, run.session().world().save().next_number);
    std::vector<std::optional<State>> states;
    for (const Run& run : runs_) states.push_back(run.edited(everywhere));
    // What is thrown or taken away may be gone from one table; what is new is to come to all.
    const bool new_ball = std::holds_alternative<lab::edit::Add>(edit);
    bool some = false;
    for (std::size_t i = 0; i < runs_.size(); ++i) {
        if (new_ball && !states[i] && !runs_[i].halt()) return false;
        some |= states[i].has_value();
    }
    if (!some) return false;
    if (under_way()) {
        edits_.push_back(edit);
        return true;
    }
    go_on_from_here();
    for (std::size_t i = 0; i < runs_.size(); ++i)
        if (states[i]) runs_[i].go_on_from(*states[i]);
    return true;
}

}  // namespace flipside::app

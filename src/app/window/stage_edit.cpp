/// What a hand does to the balls of a stage, and the scene that it has drawn.

#include <algorithm>

#include "app/window/stage.hpp"
#include "world/script_file.hpp"

namespace flipside::app {

void Stage::take(const std::string& name, std::shared_ptr<const Scene> scene) {
    if (name != name_) {
        show_scene(name, std::move(scene), before_lesson_ ? before_lesson_->line_up : line_up_);
        before_lesson_.reset();
        return start();
    }
    // An engine may refuse what the form of the file permits.
    for (const lab::Contender& contender : contenders_)
        static_cast<void>(contender.engine->make(scene, contender.settings));
    if (script_file_) script_ = load_script(*script_file_, *scene);
    original_ = std::move(scene);
    set_scene();
    start();
}

bool Stage::edit(const lab::BallEdit& edit) {
    lab::BallEdit everywhere = edit;
    if (auto* add = std::get_if<lab::edit::Add>(&everywhere))
        for (const Run& run : runs_)
            add->ball.number = std::max(add->ball.number, run.session().world().save().next_number);
    // What is thrown or taken away may be gone from one table; what is new is to come to all.
    const bool new_ball = std::holds_alternative<lab::edit::Add>(edit);
    bool some = false;
    for (const Run& run : runs_) {
        const bool possible = run.permits(everywhere);
        if (new_ball && !possible && !run.halt()) return false;
        some |= possible;
    }
    if (!some) return false;
    if (under_way()) {
        edits_.push_back(edit);
        return true;
    }
    go_on_from_here();
    for (Run& run : runs_) run.edit(everywhere);
    return true;
}

}  // namespace flipside::app

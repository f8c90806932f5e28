/// How a stage saves a game, and how one is shown again.

#include <algorithm>
#include <utility>

#include "app/window/stage.hpp"

namespace flipside::app {

Stage::Stage(std::shared_ptr<const Scene> scene, std::vector<lab::Contender> contenders, View view)
    : name_(scene->name),
      original_(scene),
      scene_(std::move(scene)),
      contenders_(std::move(contenders)),
      view_(view) {
    for (const lab::Contender& contender : contenders_) {
        line_up_.push_back(lab::plain_contender(*contender.engine));
        line_up_.back().name = contender.name;
    }
    dt_ = std::ranges::max_element(contenders_, {}, &lab::Contender::dt)->dt;
    start();
}

void Stage::compare_runs() {
    for (Divergence& divergence : divergences_)
        divergence.observe(run_named(divergence.first()), run_named(divergence.second()));
}

lab::Replay Stage::game() const {
    std::vector<lab::RecordedRun> recorded;
    for (const Run& run : runs_) recorded.push_back({run.name(), &run.session(), run.dt()});
    return lab::replay_of(recorded);
}

}  // namespace flipside::app

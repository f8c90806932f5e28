/// How a stage saves a game.

#include "app/window/stage.hpp"

namespace flipside::app {

lab::Replay Stage::game() const {
    std::vector<lab::RecordedRun> recorded;
    for (const Run& run : runs_) recorded.push_back({run.name(), &run.session(), run.dt()});
    return lab::replay_of(recorded);
}

}  // namespace flipside::app

#include "lab/session/ball_edit.hpp"

#include <algorithm>

#include "lab/session/pick.hpp"
#include "world/limits.hpp"

namespace flipside::lab {

namespace {

struct Editor {
    const Scene& scene;
    State& state;

    bool operator()(const edit::Throw& thrown) const {
        const auto ball = std::ranges::find(state.balls, thrown.ball, &Ball::number);
        if (ball == state.balls.end()) return false;
        ball->velocity = thrown.velocity;
        return within_top_speed(*ball);
    }
    bool operator()(const edit::Add& add) const {
        if (state.balls.size() >= most_things || !is_free(scene, state.balls, state.parts, add.ball))
            return false;
        const BallNumber number = std::max(add.ball.number, state.next_number);
        state.balls.push_back(add.ball);
        state.balls.back().number = number;
        state.next_number = number + 1;
        return true;
    }
    bool operator()(const edit::Remove& removed) const {
        std::erase(state.reported_lost, removed.ball);
        std::erase_if(state.blocked, [&](const Blocked& blocked) { return blocked.ball == removed.ball; });
        return std::erase_if(state.balls, [&](const Ball& ball) { return ball.number == removed.ball; }) > 0;
    }
};

}  // namespace

std::optional<State> edited(const Scene& scene, State state, const BallEdit& edit) {
    if (!std::visit(Editor{scene, state}, edit)) return std::nullopt;
    // Whatever lay on a ball that is gone, or in the way of one that was thrown, is to notice it.
    for (Ball& ball : state.balls) ball.asleep = false;
    state.origin.reset();
    return state;
}

}  // namespace flipside::lab

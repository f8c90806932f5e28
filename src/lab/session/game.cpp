#include "lab/session/game.hpp"

#include <algorithm>
#include <cmath>

namespace flipside::lab {

namespace {

/// A spinner loses speed evenly, so the root of the half turns still to come falls evenly: by this much
/// a second. 16 half turns take 2 s.
constexpr double spinner_drag = 2;

}  // namespace

Game::Game(std::shared_ptr<const Scene> scene)
    : scene_(std::move(scene)),
      rules_(scene_->rules.value_or(Rules{})),
      points_(scene_->parts.size()),
      hit_(scene_->parts.size()),
      spins_(rules_.spinners.size()),
      in_play_(scene_->balls.size()),
      balls_left_(scene_->rules ? rules_.balls : 0) {
    for (const Rules::Score& score : rules_.scores) points_[score.part] = score.points;
}

bool Game::permits(const Control& control, std::span<const Ball> balls) const {
    if (!scene_->rules) return true;
    if (const auto* flip = std::get_if<control::Flip>(&control)) return !(tilted_ && flip->up);
    if (!std::holds_alternative<control::Launch>(control)) return true;
    if (!scene_->launcher || over_) return false;
    if (balls.empty()) return balls_left_ > 0;
    return scene_->launcher->plunger && std::ranges::all_of(balls, [&](const Ball& ball) {
               return length(ball.position - scene_->launcher->position) < ball.radius;
           });
}

void Game::applied(const Control& control, double time) {
    if (std::holds_alternative<control::Launch>(control)) save_until_ = time + rules_.ball_save;
    if (!std::holds_alternative<control::Nudge>(control) || !scene_->rules) return;
    std::erase_if(nudges_, [&](double earlier) { return earlier <= time - rules_.tilt_seconds; });
    nudges_.push_back(time);
    if (std::ssize(nudges_) >= rules_.tilt_nudges && !tilted_ && in_play_ > 0)
        tilted_ = drop_flippers_ = true;
}

std::vector<Control> Game::observe(std::span<const Event> events, double time, std::size_t balls_in_play) {
    int lost_now = 0;
    for (const Event& event : events) {
        if (event.kind == EventKind::lost) ++lost_now;
        const bool touches = event.kind == EventKind::impact || event.kind == EventKind::sensor_begin;
        if (touches && !event.other.is_ball) hit(event.other.index, event.speed);
    }
    spin(time - time_);
    time_ = time;
    count_balls(balls_in_play, lost_now);

    std::vector<Control> answer;
    if (drop_flippers_) {
        answer.emplace_back(control::Flip{Side::left, false});
        answer.emplace_back(control::Flip{Side::right, false});
        drop_flippers_ = false;
    }
    for (const Rules::Group* group : complete(rules_.targets))
        answer.emplace_back(control::RaiseTargets{group->parts});
    complete(rules_.lanes);
    return answer;
}

void Game::resume(std::size_t balls_in_play, double time) {
    in_play_ = balls_in_play;
    own_in_play_ = std::min(own_in_play_, static_cast<int>(balls_in_play));
    time_ = time;
}

void Game::hit(PartIndex part, double speed) {
    hit_[part] = true;
    score(points_[part]);
    for (std::size_t i = 0; i < spins_.size(); ++i)
        if (rules_.spinners[i].part == part) spins_[i] += speed * rules_.spinners[i].turns_per_speed;
}

void Game::spin(double seconds) {
    for (std::size_t i = 0; i < spins_.size(); ++i) {
        const double root = std::max(0.0, std::sqrt(spins_[i]) - spinner_drag * seconds);
        const double left = root * root;
        score(std::lround(std::floor(spins_[i]) - std::floor(left)) * rules_.spinners[i].points);
        spins_[i] = left;
    }
}

void Game::count_balls(std::size_t balls_in_play, int lost_now) {
    const long gone = scene_->keep_lost ? 0 : lost_now;
    const long entered =
        std::max(0L, static_cast<long>(balls_in_play) - (static_cast<long>(in_play_) - gone));
    in_play_ = balls_in_play;
    launched_ += entered;
    lost_ += lost_now;
    if (!scene_->rules) return;

    const int own = std::min(balls_left_, static_cast<int>(entered));
    balls_left_ -= own;
    own_in_play_ += own;
    if (time_ <= save_until_) {
        const int saved = std::min(own_in_play_, lost_now);
        balls_left_ += saved;
        own_in_play_ -= saved;
    }
    own_in_play_ = std::min(own_in_play_, static_cast<int>(in_play_));
    if (in_play_ > 0) return;
    if (lost_now > 0) {
        tilted_ = false;
        nudges_.clear();
    }
    over_ = balls_left_ == 0;
}

std::vector<const Rules::Group*> Game::complete(std::span<const Rules::Group> groups) {
    std::vector<const Rules::Group*> completed;
    for (const Rules::Group& group : groups) {
        if (!std::ranges::all_of(group.parts, [&](PartIndex part) { return hit_[part]; })) continue;
        for (const PartIndex part : group.parts) hit_[part] = false;
        score(group.bonus);
        completed.push_back(&group);
    }
    return completed;
}

double Game::spinning(PartIndex spinner) const {
    double left = 0;
    for (std::size_t i = 0; i < spins_.size(); ++i)
        if (rules_.spinners[i].part == spinner) left += spins_[i];
    return left;
}

}  // namespace flipside::lab

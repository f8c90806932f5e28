#include "lab/game/game.hpp"

#include <algorithm>
#include <utility>

namespace flipside::lab {

namespace {

constexpr std::size_t most_captions = 8;

std::shared_ptr<const Rules> rules_of(const std::shared_ptr<const Scene>& scene) {
    return scene->rules ? std::shared_ptr<const Rules>(scene, &*scene->rules)
                        : std::make_shared<const Rules>();
}

}  // namespace

Game::Game(std::shared_ptr<const Scene> scene)
    : scene_(std::move(scene)),
      rules_(rules_of(scene_)),
      groups_(scene_->parts.size()),
      spinners_(rules_->spinners.size()),
      turns_(scene_->rules ? rules_->balls : 0, rules_->ball_save, scene_->balls.size()),
      banks_done_(rules_->targets.size()) {
    std::vector<Points> points(scene_->parts.size());
    for (const Rules::Score& score : rules_->scores) points[score.part].now = score.points;
    if (rules_->end_bonus)
        for (const Rules::Score& score : rules_->end_bonus->scores) points[score.part].end = score.points;
    points_ = std::make_shared<const std::vector<Points>>(std::move(points));
}

bool Game::permits(const Control& control, std::span<const Ball> balls) const {
    if (!scene_->rules) return true;
    if (const auto* flip = std::get_if<control::Flip>(&control)) return !(tilt_.tilted() && flip->up);
    if (!std::holds_alternative<control::Launch>(control)) return true;
    if (!scene_->launcher || over_) return false;
    if (balls.empty()) return turns_.left() > 0 && !turns_.bringing();
    return scene_->launcher->plunger && std::ranges::any_of(balls, [&](const Ball& ball) {
               return length(ball.position - scene_->launcher->position) < ball.radius;
           });
}

void Game::applied(const Control& control, double time) {
    if (!scene_->rules) return;
    time_ = time;
    if (std::holds_alternative<control::Launch>(control)) turns_.launched(time);
    if (const auto* flip = std::get_if<control::Flip>(&control)) {
        held_[static_cast<int>(flip->side)] = flip->up;
        if (flip->up) raise(flip->side);
    }
    if (!std::holds_alternative<control::Nudge>(control) || !turns_.any_in_play()) return;
    const Tilt::Answer answer = tilt_.nudge(*rules_, time);
    if (answer == Tilt::Answer::warning) tell(CaptionKind::tilt_warning);
    if (answer != Tilt::Answer::tilted) return;
    drop_flippers_ = true;
    held_[0] = held_[1] = false;
    turns_.forfeit();
    tell(CaptionKind::tilt);
}

void Game::raise(Side side) {
    if (tilt_.tilted()) return;
    for (const Rules::Group& lanes : rules_->lanes)
        if (lanes.shift) groups_.shift(lanes, side);
    if (rules_->skill_shot) skill_ = beside(skill_, rules_->skill_shot->parts.size(), side);
}

std::vector<Control> Game::observe(std::span<const Event> events, double time, std::span<const Ball> balls) {
    const double before = std::exchange(time_, time);
    int lost = 0;
    for (const Event& event : events) {
        if (event.kind == EventKind::lost) ++lost;
        const bool touches = event.kind == EventKind::impact || event.kind == EventKind::sensor_begin;
        if (touches && !event.other.is_ball) hit(event.other.index, event.speed);
    }
    score(spinners_.turn(rules_->spinners, time - before));

    std::vector<Control> answer;
    if (std::exchange(drop_flippers_, false)) {
        answer.emplace_back(control::Flip{Side::left, false});
        answer.emplace_back(control::Flip{Side::right, false});
    }
    complete_lanes();
    complete_targets(answer);
    count_balls(lost, balls.size());
    if (!scene_->rules) return answer;
    bring_balls(balls, answer);
    if (rules_->ball_search > 0) {
        const int searches = search_.begun();
        const auto does = search_.look(events, balls, *scene_, held_, time);
        answer.insert(answer.end(), does.begin(), does.end());
        if (search_.begun() > searches) tell(CaptionKind::ball_search);
    }
    return answer;
}

void Game::resume(const State& state) {
    std::size_t waiting = 0;
    for (const control::Launch& launch : state.launches) waiting += static_cast<std::size_t>(launch.count);
    turns_.resume(state.balls.size(), waiting);
    // A target that is down cannot be hit any more.
    for (const Rules::Group& bank : rules_->targets)
        for (const PartIndex part : bank.parts)
            if (state.parts[part].down) groups_.mark(part);
    time_ = state.clock.time;
}

void Game::hit(PartIndex part, double speed) {
    const Points points = (*points_)[part];
    score(points.now);
    if (!tilt_.tilted()) end_bonus_ += points.end;
    if (const auto lane = skill_shot(); lane && scores(part)) {
        skill_open_ = false;
        if (part == *lane) {
            score(rules_->skill_shot->bonus);
            tell(CaptionKind::skill_shot, rules_->skill_shot->bonus);
        }
    }
    if (scores(part)) turns_.scored();
    hit_in_group(part);
    spinners_.pass(rules_->spinners, part, speed);
}

void Game::hit_in_group(PartIndex part) {
    if (!groups_.hit(part) || tilt_.tilted()) return;
    const auto tell_of = [&](std::span<const Rules::Group> groups, CaptionKind kind) {
        for (const Rules::Group& group : groups)
            if (std::ranges::find(group.parts, part) != group.parts.end())
                tell(kind, groups_.count(group), static_cast<long>(group.parts.size()));
    };
    tell_of(rules_->lanes, CaptionKind::lane);
    tell_of(rules_->targets, CaptionKind::target);
}

void Game::complete_lanes() {
    for (const Rules::Group& lanes : rules_->lanes) {
        if (!groups_.is_complete(lanes)) continue;
        groups_.reset(lanes);
        score(lanes.bonus);
        if (tilt_.tilted()) continue;
        if (rules_->end_bonus) times_ = std::min(times_ + 1, rules_->end_bonus->most_times);
        tell(CaptionKind::lanes_complete, lanes.bonus, times_);
    }
}

void Game::complete_targets(std::vector<Control>& answer) {
    for (std::size_t i = 0; i < rules_->targets.size(); ++i) {
        const Rules::Group& bank = rules_->targets[i];
        if (!groups_.is_complete(bank)) continue;
        groups_.reset(bank);
        answer.emplace_back(control::RaiseTargets{bank.parts});
        score(bank.bonus);
        if (tilt_.tilted()) continue;
        banks_done_[i] = true;
        const bool counts = rules_->multiball && !turns_.multiball();
        tell(CaptionKind::bank_complete, bank.bonus, counts ? std::ranges::count(banks_done_, false) : 0);
        if (!rules_->multiball) continue;
        if (turns_.multiball()) {
            score(rules_->multiball->jackpot);
            tell(CaptionKind::jackpot, rules_->multiball->jackpot);
        } else if (std::ranges::count(banks_done_, false) == 0) {
            std::fill(banks_done_.begin(), banks_done_.end(), false);
            turns_.start_multiball(rules_->multiball->balls, time_);
            tell(CaptionKind::multiball, rules_->multiball->balls);
        }
    }
}

void Game::count_balls(int lost, std::size_t balls) {
    const Turns::Change change = turns_.count(balls, lost, scene_->keep_lost ? 0 : lost, time_);
    if (change.saved > 0) tell(CaptionKind::ball_saved, change.again ? 1 : 0);
    if (change.ended) end_turn();
}

void Game::end_turn() {
    if (rules_->end_bonus && end_bonus_ > 0 && !tilt_.tilted()) {
        score(times_ * end_bonus_);
        tell(CaptionKind::bonus, end_bonus_, times_);
    }
    end_bonus_ = 0;
    times_ = 1;
    skill_open_ = true;
    skill_ = 0;
    tilt_.reset();
    over_ = turns_.left() == 0;
}

/// One at a time, and only where nothing lies: a ball at the plunger is the player's to fire.
void Game::bring_balls(std::span<const Ball> balls, std::vector<Control>& answer) {
    if (!turns_.is_due(time_)) return;
    const Launcher& launcher = *scene_->launcher;
    const bool free = std::ranges::none_of(balls, [&](const Ball& ball) {
        return length(ball.position - launcher.position) < 2 * (ball.radius + launcher.ball.radius);
    });
    if (!free) return;
    answer.emplace_back(control::Launch{rules_->multiball->strength});
    turns_.brought(time_);
}

bool Game::scores(PartIndex part) const {
    return (*points_)[part].now != 0;
}

std::optional<PartIndex> Game::skill_shot() const {
    if (!rules_->skill_shot || !skill_open_ || over_) return std::nullopt;
    return rules_->skill_shot->parts[skill_];
}

double Game::spinning(PartIndex spinner) const {
    return spinners_.left(rules_->spinners, spinner);
}

void Game::tell(CaptionKind kind, long value, long of) {
    if (captions_.size() == most_captions) captions_.erase(captions_.begin());
    captions_.push_back({kind, time_, value, of});
    ++told_;
}

}  // namespace flipside::lab

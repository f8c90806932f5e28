#include "custom/world.hpp"

#include <algorithm>
#include <tuple>

#include "custom/broad_phase/registry.hpp"
#include "custom/engine.hpp"
#include "custom/geometry/enclosing.hpp"
#include "custom/stopwatch.hpp"

namespace flipside::custom {

namespace {

Vec2 middle(const Box& box) {
    return 0.5 * (box.min + box.max);
}

}  // namespace

CustomWorld::CustomWorld(std::shared_ptr<const Scene> scene, const Settings& settings)
    : scene_(std::move(scene)),
      settings_(settings),
      table_(scene_),
      layout_(*scene_),
      broad_(make_broad_phase(*scene_, layout_.still_proxies(), settings)),
      simple_(*scene_, layout_, settings_),
      discrete_(*scene_, layout_, settings_),
      continuous_(table_, layout_, settings_),
      sleep_(settings_.sleep_speed, length(scene_->gravity)),
      balls_(scene_->balls) {
    make_room();
    touches_.refresh(layout_, table_, balls_, *broad_, discrete_.near(), true);
    any_asleep_ = std::ranges::any_of(balls_, &Ball::asleep);
    fill_statistics(0);
}

/// Lists grow here, when balls join, and hardly ever in a step.
void CustomWorld::make_room() {
    custom::make_room(balls_, balls_.size() + 1);
    if (steps_simply()) simple_.reserve(balls_.size());
    discrete_.reserve(balls_.size());
    guard_.reserve(balls_.capacity(), std::max(least_room, balls_.capacity() * contacts_per_ball));
    if (steps_continuously()) continuous_.reserve(balls_.size());
    touches_.reserve(layout_.size(), balls_.size());
    sleep_.reserve(balls_.size());
    custom::make_room(table_.pressings(), balls_.size(), contacts_per_ball);
    custom::make_room(record_.events, balls_.size(), events_per_ball);
    custom::make_room(record_.crossed, balls_.size(), touches_per_ball);
}

void CustomWorld::step(double dt) {
    const bool in_window = in_window_;
    continuous_.keep_start();
    guard_.run(
        table_, balls_, [&] { make_step(dt); },
        [&](State before) {
            if (in_window) before.origin = origin_of(continuous_.kept_start());
            restore(before);
        });
}

void CustomWorld::make_step(double dt) {
    const std::uint64_t tests_before = box_tests();
    record_.events.clear();
    record_.crossed.clear();
    record_.statistics = {};
    record_.broad_seconds = record_.flight_seconds = record_.contact_seconds = record_.report_seconds = 0;

    launch();
    if (steps_continuously()) {
        step_in_windows(dt);
        report_continuous();
        // Who was woken sets out anew.
        if (touches_.wake_unsupported(balls_, scene_->gravity)) in_window_ = false;
        return fill_statistics(box_tests() - tests_before);
    }
    in_window_ = was_continuous_ = false;
    if (falls_asleep()) sleep_.watch(balls_, dt);
    if (steps_simply())
        simple_.step(table_, balls_, dt, *broad_, record_);
    else
        discrete_.step(table_, balls_, dt, *broad_, record_);
    table_.advance(dt);
    if (steps_simply())
        report_simple();
    else
        report_discrete();
    any_asleep_ |= falls_asleep() && sleep_.settle(balls_, contacts(), dt);
    touches_.wake_unsupported(balls_, scene_->gravity);
    fill_statistics(box_tests() - tests_before);
}

/// The continuous solver works in windows whose ends lie on a grid of the world's time, whatever the steps:
/// so they only say when the balls are looked at, and the outcome is the same, to the bit. A window begins
/// where the last one ended, or where something from outside has changed the world.
void CustomWorld::step_in_windows(double dt) {
    Clock now = table_.clock();
    now.advance(dt);
    for (bool done = false; !done;) {
        if (!in_window_) begin_window();
        const bool whole = window_end_ <= now.time;
        const Clock reached = window_end_ < now.time ? Clock{window_end_, 0} : now;
        const double ahead = reached.time - continuous_.start().clock.time;
        continuous_.run(ahead, record_);
        table_.set_to(reached, continuous_.start().parts, ahead);
        done = window_end_ >= now.time;
        if (whole)
            end_window();
        else
            continuous_.read(ahead, now.time, balls_);
    }
}

void CustomWorld::begin_window() {
    in_window_ = true;
    if (!was_continuous_) continuous_.reset(table_, balls_);
    was_continuous_ = true;
    // Who may fall asleep is looked at often.
    constexpr double often = 1.0 / 60, seldom = 1.0 / 4;  // s; steps of 1/60 s, summed up, end with a window
    bool may_settle = false;
    if (settings_.sleep) {
        sleep_.forget();
        sleep_.watch(balls_, often);
        may_settle = sleep_.may_settle(balls_);
    }
    const double window = may_settle ? often : seldom;
    double next = std::floor(time() / window) + 1;
    while (next * window <= time()) ++next;
    window_end_ = next * window;
    const double length = window_end_ - time();
    continuous_.begin(table_, balls_, length, record_);
}

void CustomWorld::end_window() {
    continuous_.end(time(), balls_);
    in_window_ = false;
    if (!settings_.sleep || window_end_ - continuous_.start().clock.time > 1.0 / 30) return;
    look_over_all();
    if (!sleep_.may_settle(balls_)) return;
    find_touches();
    any_asleep_ |= sleep_.settle(balls_, contacts(), window_end_ - continuous_.start().clock.time);
    touches_.wake_unsupported(balls_, scene_->gravity);
}

/// Notes after the step what depends on every ball, in one look at each. Whether all are inside.
bool CustomWorld::look_over(auto&& each_ball) {
    bool all_inside = true;
    any_asleep_ = false;
    sleep_.begin_look(balls_.size());
    each_ball([&](std::size_t place, const Ball& ball) {
        all_inside &= scene_->bounds.contains(ball.position);
        any_asleep_ |= ball.asleep;
        sleep_.look(place, ball);
    });
    return all_inside;
}

void CustomWorld::look_over_all() {
    look_over([&](auto&& see) {
        for (std::size_t i = 0; i < balls_.size(); ++i) see(i, balls_[i]);
    });
}

void CustomWorld::report_simple() {
    Stopwatch watch;
    look_over_all();
    lose_balls();
    touches_.refresh(layout_, table_, balls_, *broad_, discrete_.near(), true);
    touches_.report_touches(time(), record_.events);
    touches_.report_sensors(time(), record_.crossed, record_.events);
    sort_events();
    watch.lap(record_.report_seconds);
}

void CustomWorld::report_continuous() {
    look_over_all();
    find_touches();
    sort_events();
}

void CustomWorld::find_touches() {
    if (continuous_.quiet() && contacts().empty()) return touches_.clear();
    touches_.refresh(layout_, table_, balls_, continuous_.find_pairs(balls_));
    touches_.report_touches(time(), record_.events);
}

void CustomWorld::report_discrete() {
    Stopwatch watch;
    const bool all_inside = look_over([&](auto&& see) { discrete_.land(balls_, see); });
    watch.lap(record_.flight_seconds);
    // The solver's pairs are by place.
    if (all_inside || !lose_balls())
        touches_.refresh(layout_, table_, balls_, discrete_.part_pairs(), discrete_.ball_pairs());
    else
        touches_.refresh(layout_, table_, balls_, *broad_, discrete_.near(), false);
    touches_.report_touches(time(), record_.events);
    touches_.report_sensors(time(), record_.crossed, record_.events);
    sort_events();
    watch.lap(record_.report_seconds);
}

void CustomWorld::sort_events() {
    std::ranges::sort(record_.events, [](const Event& a, const Event& b) {
        return std::tie(a.time, a.kind, a.ball, a.other, a.speed, a.impulse) <
               std::tie(b.time, b.kind, b.ball, b.other, b.speed, b.impulse);
    });
}

std::uint64_t CustomWorld::box_tests() const {
    return broad_->tests() + discrete_.near().tests();
}

bool CustomWorld::steps_continuously() const {
    constexpr std::size_t few = 64;
    return settings_.solver == "continuous" || (settings_.solver == "auto" && balls_.size() <= few);
}

void CustomWorld::launch() {
    while (table_.launch_waiting()) {
        const auto launched = table_.launch(balls_);
        if (!launched) return;
        sleep_.forget();
        in_window_ = false;
        if (launched->existing) {
            *std::ranges::lower_bound(balls_, launched->ball.number, {}, &Ball::number) = launched->ball;
        } else {
            balls_.push_back(launched->ball);
            balls_.back().number = table_.new_number();
            make_room();
        }
    }
}

/// Whether any left the list.
bool CustomWorld::lose_balls() {
    auto& reported = table_.reported_lost();
    const auto outside = [&](const Ball& ball) { return !scene_->bounds.contains(ball.position); };
    for (const Ball& ball : balls_) {
        if (!outside(ball) || std::ranges::find(reported, ball.number) != reported.end()) continue;
        record_.events.push_back({time(), EventKind::lost, ball.number, {}, ball.position, {}, 0, 0});
        if (scene_->keep_lost) reported.push_back(ball.number);
    }
    if (scene_->keep_lost || std::erase_if(balls_, outside) == 0) return false;
    look_over_all();
    return true;
}

void CustomWorld::fill_statistics(std::uint64_t pair_tests) {
    Statistics& statistics = record_.statistics;
    statistics.pair_tests += pair_tests;
    statistics.narrow_tests += touches_.narrow_tests();
    if (any_asleep_)
        statistics.asleep = static_cast<std::uint64_t>(std::ranges::count_if(balls_, &Ball::asleep));
    for (const Contact& contact : contacts())
        statistics.max_penetration = std::max(statistics.max_penetration, -contact.separation);
    if (steps_continuously()) {
        // Every ball keeps its own list of what is near; nothing is sought for all of them. There are no
        // stages, and a step takes less time than reading the clock a few times.
        statistics.solver = "continuous";
        statistics.broad_phase.name = "list per ball";
        return;
    }
    statistics.solver = steps_simply() ? "simple" : "discrete";
    statistics.broad_phase = broad_->facts();
    statistics.stages[0] = {"broad phase", record_.broad_seconds};
    statistics.stages[1] = {"flight", record_.flight_seconds};
    statistics.stages[2] = {"contact", record_.contact_seconds};
    statistics.stages[3] = {"report", record_.report_seconds};
}

void CustomWorld::wake_all() {
    for (Ball& ball : balls_) ball.asleep = false;
}

void CustomWorld::apply(const Control& control) {
    sleep_.forget();
    in_window_ = false;
    table_.apply(control);
    if (const auto* nudge = std::get_if<control::Nudge>(&control)) {
        wake_all();
        for (Ball& ball : balls_) ball.velocity += nudge->velocity;
    }
    if (std::holds_alternative<control::RaiseTargets>(control)) {
        wake_all();
        touches_.refresh(layout_, table_, balls_, *broad_, discrete_.near(), false);
    }
}

BallNumber CustomWorld::add(const Ball& ball) {
    sleep_.forget();
    in_window_ = false;
    balls_.push_back(ball);
    balls_.back().number = table_.new_number();
    make_room();
    touches_.refresh(layout_, table_, balls_, *broad_, discrete_.near(), false);
    return balls_.back().number;
}

bool CustomWorld::remove(BallNumber number) {
    if (std::erase_if(balls_, [&](const Ball& ball) { return ball.number == number; }) == 0) return false;
    std::erase(table_.reported_lost(), number);
    sleep_.forget();
    in_window_ = was_continuous_ = false;
    wake_all();
    touches_.refresh(layout_, table_, balls_, *broad_, discrete_.near(), false);
    return true;
}

std::shared_ptr<const State> CustomWorld::origin_of(const State& start) {
    auto origin = std::make_shared<State>(start);
    Table::forget_gone(*origin);
    return origin;
}

State CustomWorld::save() const {
    State state = table_.save(balls_);
    if (in_window_) state.origin = origin_of(continuous_.start());
    return state;
}

void CustomWorld::restore(const State& state) {
    guard_.forget();
    if (!resume(state)) load(state);
    record_.events.clear();
    record_.statistics = {};
    touches_.refresh(layout_, table_, balls_, *broad_, discrete_.near(), true);
}

void CustomWorld::load(const State& state) {
    sleep_.forget();
    table_.restore(state);
    balls_ = state.balls;
    in_window_ = was_continuous_ = false;
    make_room();
}

/// Goes through the window in which the state was saved, from its start. False where that does not lead to
/// the state: it is another engine's, or was changed.
bool CustomWorld::resume(const State& state) {
    if (!state.origin) return false;
    load(*state.origin);
    if (!steps_continuously()) return false;
    begin_window();
    if (!(state.clock.time >= time() && state.clock.time < window_end_)) return false;
    const double ahead = state.clock.time - time();
    try {
        continuous_.run(ahead, record_);
    } catch (const Refusal&) {
        return false;
    }
    table_.set_to(state.clock, continuous_.start().parts, ahead);
    continuous_.read(ahead, time(), balls_);
    State reached = save();
    reached.origin = state.origin;
    return reached == state;
}

void CustomWorld::inspect_boxes(Inspector& inspector) const {
    for (PieceIndex i = 0; i < layout_.size(); ++i)
        inspector.box(Topic::boxes, bounds_of(layout_.piece(i), table_.pose(layout_.piece(i).part)));
    for (const Ball& ball : balls_) inspector.box(Topic::boxes, bounds_of(ball.position, ball.radius));
    inspect_turning_bounds(inspector);
}

/// Of moving parts also the bounds that turn with them: circle and rectangle.
void CustomWorld::inspect_turning_bounds(Inspector& inspector) const {
    std::vector<Vec2> outline;
    for (PartIndex part = 0; part < scene_->parts.size(); ++part) {
        if (!Table::moves(scene_->parts[part])) continue;
        outline.clear();
        for (const Piece& piece : layout_.pieces())
            if (piece.part == part) append_outline(piece, table_.pose(part), outline);
        const Disc disc = enclosing_disc(outline);
        inspector.circle(Topic::boxes, disc.center, disc.radius);
        const auto corners = enclosing_rectangle(outline).corners();
        for (std::size_t i = 0; i < 4; ++i) inspector.segment(Topic::boxes, corners[i], corners[(i + 1) % 4]);
    }
}

void CustomWorld::inspect(Inspector& inspector) const {
    if (inspector.wants(Topic::boxes)) inspect_boxes(inspector);
    if (inspector.wants(Topic::cells)) broad_->inspect(inspector);
    if (inspector.wants(Topic::pairs)) {
        const auto place = [&](Handle handle) {
            if (handle >= layout_.size()) return balls_[handle - layout_.size()].position;
            const Piece& piece = layout_.piece(handle);
            return middle(bounds_of(piece, table_.pose(piece.part)));
        };
        for (const auto pairs : {touches_.part_pairs(), touches_.ball_pairs()})
            for (const Pair pair : pairs) inspector.pair(place(pair.a), place(pair.b));
    }
    if (inspector.wants(Topic::contacts))
        for (const Contact& contact : contacts()) inspector.contact(contact);
    if (inspector.wants(Topic::sleep))
        for (const Ball& ball : balls_)
            if (ball.asleep) inspector.circle(Topic::sleep, ball.position, ball.radius);
}

const Engine& engine() {
    static const Engine custom{
        engine_name, "the bespoke engine: shapes, quadtree and response written here to be read",
        setting_specs(), [](std::shared_ptr<const Scene> scene, const Settings& settings) {
            return std::unique_ptr<World>(std::make_unique<CustomWorld>(std::move(scene), settings));
        }};
    return custom;
}

}  // namespace flipside::custom

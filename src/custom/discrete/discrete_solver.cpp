#include "custom/discrete/discrete_solver.hpp"

#include <algorithm>
#include <chrono>
#include <optional>

#include "custom/broad_phase/room.hpp"
#include "custom/flight.hpp"
#include "custom/geometry/sweep.hpp"
#include "custom/sift.hpp"

namespace flipside::custom {

namespace {

/// Adds the time since the last call to a stage.
class Stopwatch {
  public:
    void lap(double& seconds) {
        const auto now = std::chrono::steady_clock::now();
        seconds += std::chrono::duration<double>(now - last_).count();
        last_ = now;
    }

  private:
    std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

/// A swept ball stops this near to a surface, in radii.
constexpr double stop_distance = 1e-7;

}  // namespace

DiscreteSolver::DiscreteSolver(const Scene& scene, const Layout& layout, const SolverSettings& settings)
    : scene_(scene),
      layout_(layout),
      settings_(settings),
      pull_(length(scene.gravity)),
      any_sensor_(std::ranges::any_of(scene.parts, &Part::sensor)),
      near_(layout.still_proxies()) {
    for (PartIndex i = 0; i < scene.parts.size(); ++i)
        if (gate_of(scene.parts[i]) != nullptr) gates_.push_back(i);
}

void DiscreteSolver::reserve(std::size_t balls) {
    make_room(moving_, layout_.size() + balls);
    make_room(started_, balls);
    make_room(waiting_, balls);
    for (auto* room : {&candidate_room_, &touching_room_}) make_room(*room, balls, contacts_per_ball);
    make_room(ball_pair_room_, balls, contacts_per_ball);
    make_room(around_, layout_.size());
    make_room(found_, layout_.size() + balls);
    near_.reserve(layout_.size() + balls, balls);
    make_room(deep_, layout_.size());
    make_room(changed_in_, balls);
    make_room(flown_, balls);
    for (auto* marks : {&in_pile_, &pushed_}) make_room(*marks, balls);
    make_room(pressing_, balls, contacts_per_ball);
    make_room(pressed_, balls, contacts_per_ball);
    pile_.reserve(balls);
}

void DiscreteSolver::step(Table& table, std::vector<Ball>& balls, double dt, BroadPhase& broad,
                          StepRecord& record) {
    table_ = &table, balls_ = &balls, record_ = &record, broad_ = &broad, dt_ = dt;
    const int iterations = settings_.motion_iterations;
    const double flight = dt / iterations;
    Stopwatch watch;
    const auto box_of = [](const Ball& ball) { return bounds_of(ball.position, ball.radius); };
    layout_.place(table, balls, 0, 0, false, box_of, moving_);
    near_.recognise(moving_);
    for (int i = 0; i < iterations; ++i) {
        span_ = {i * flight, i + 1 == iterations ? dt : (i + 1) * flight};
        start_flights(span_.duration());
        watch.lap(record.flight_seconds);
        find_candidates();
        watch.lap(record.broad_seconds);
        finish_flights(span_.duration());
        watch.lap(record.flight_seconds);
        watch_gates();
        collide();
        keep_sides();
        watch_sensors();
        watch.lap(record.contact_seconds);
        ++record.statistics.substeps;
    }
}

/// Flies the balls that no part can stop in mid-flight, because they are slow and only still parts are
/// near; the others wait. Notes for all in which box they stay.
void DiscreteSolver::start_flights(double duration) {
    std::vector<Ball>& balls = *balls_;
    const PieceIndex first = moving_pieces();
    near_.begin();
    std::optional<Box> swept;  // by moving parts
    for (PieceIndex i = 0; i < first; ++i) {
        moving_[i] = layout_.proxy(*table_, layout_.size() - first + i, span_.begin, span_.end);
        near_.check(i, moving_[i]);
        swept = swept ? united(*swept, moving_[i].box) : moving_[i].box;
    }
    const Stretch stretch(scene_.damping, duration);
    const Vec2 gravity = scene_.gravity;
    const double fall = pull_ * duration * duration, sweep_from = settings_.sweep_from;
    flown_.assign(balls.size(), duration);
    waiting_.clear();
    started_.resize(balls.size());
    Vec2* start = started_.data();
    Proxy* proxy = moving_.data() + first;
    Ball* const balls_begin = balls.data();
    for (Ball* ball = balls_begin; ball != balls_begin + balls.size(); ++ball, ++proxy) {
        *start++ = ball->position;
        if (!ball->asleep) {
            const double radius = ball->radius;
            const Vec2 here = ball->position, there = end_of_flight(*ball, gravity, stretch);
            // What may sink in deep: way(ball, duration) > deep, without the root.
            const double slow = sweep_from * radius - fall;
            proxy->active = true;
            if ((slow < 0) | (length_squared(ball->velocity) * duration * duration > slow * slow)) {
                // It may be turned round in mid-flight, so it can end anywhere within its reach.
                proxy->box = bounds_of(here, radius + way(*ball, duration));
                waiting_.push_back(static_cast<std::uint32_t>(ball - balls_begin));
            } else {
                proxy->box = {{std::min(here.x, there.x) - radius, std::min(here.y, there.y) - radius},
                              {std::max(here.x, there.x) + radius, std::max(here.y, there.y) + radius}};
                if (swept && overlap(*swept, proxy->box))
                    waiting_.push_back(static_cast<std::uint32_t>(ball - balls_begin));
                else
                    fly_freely(*ball, gravity, stretch);
            }
        }
        near_.check(static_cast<std::uint32_t>(proxy - moving_.data()), *proxy);
    }
}

void DiscreteSolver::find_candidates() {
    std::vector<Ball>& balls = *balls_;
    const PieceIndex first = moving_pieces();
    const auto roomy = [&](std::uint32_t i) { return i < first ? room_of_part(i) : room_of_ball(i - first); };
    const std::span<const Pair> pairs = near_.find_pairs_of_checked(moving_, *broad_, roomy);
    const Handle first_ball = layout_.size();
    candidates_ = sift(
        pairs, candidate_room_, [&](Pair pair) { return pair.a < first_ball; }, Nothing{},
        [&](Pair pair) {
            return Candidate{pair.b - first_ball, pair.a};
        });
    ball_pairs_ = sift(
        pairs, ball_pair_room_, [&](Pair pair) { return pair.a >= first_ball; }, Nothing{},
        [&](Pair pair) {
            return BallPair{pair.a - first_ball, pair.b - first_ball};
        });
    for (const auto [b, piece] : candidates_) {
        if (!balls[b].asleep) continue;
        balls[b].asleep = false;  // only a part in motion is paired with a sleeper
        waiting_.push_back(b);
    }
}

/// Flies those that wait.
void DiscreteSolver::finish_flights(double duration) {
    std::ranges::sort(waiting_);
    auto next = candidates_.begin();
    for (const std::uint32_t place : waiting_) {
        next = std::find_if(next, candidates_.end(), [&](const Candidate& c) { return c.ball >= place; });
        const auto last =
            std::find_if(next, candidates_.end(), [&](const Candidate& c) { return c.ball > place; });
        fly((*balls_)[place], {next, last}, duration);
        next = last;
    }
}

/// Whether something closing in at `approach` m/s can get too deep during `duration`.
bool DiscreteSolver::sinks(double approach, const Ball& ball, double duration) const {
    return approach * duration > settings_.sweep_from * ball.radius;
}

/// Flies on, bouncing off parts where that needs the exact time of touch. What is left of the time after
/// as many bounces as there are collision iterations is dropped: the ball waits.
void DiscreteSolver::fly(Ball& ball, std::span<const Candidate> near, double duration) {
    double searched = way(ball, duration);
    double at = 0;
    for (int bounces = 0; bounces < settings_.collision_iterations; ++bounces) {
        const double remaining = duration - at;
        double soonest = never;
        PieceIndex met = 0;
        for (const Candidate& candidate : near) {
            const double time = first_touch_of(ball, candidate.piece, at, remaining);
            if (time < soonest) soonest = time, met = candidate.piece;
        }
        fly_freely(ball, scene_.gravity, Stretch(scene_.damping, std::min(soonest, remaining)));
        if (soonest == never) return;
        at += soonest;
        const Piece& piece = layout_.piece(met);
        const Pose pose = layout_.pose(*table_, met, span_.begin + at);
        double flown = 0;
        respond_to(ball, met, touch(ball.position, ball.radius, piece, pose), at, flown);
        flown_[static_cast<std::size_t>(&ball - balls_->data())] = duration - at;
        // Kicked faster, it leaves the surroundings that were searched for parts.
        if (way(ball, duration) > searched) {
            searched = way(ball, duration);
            near = look_around(ball, searched);
        }
    }
}

/// Where a moving part may get until the end of the step, from now on.
Box DiscreteSolver::room_of_part(std::size_t moving) const {
    const Box& now = moving_[moving].box;
    if (settings_.search_room == 0) return now;
    const auto piece = static_cast<PieceIndex>(layout_.still_proxies().size() + moving);
    return united(now, layout_.proxy(*table_, piece, span_.begin, dt_).box);
}

/// The same of a ball, wherever it turns, and some room for what gives it speed meanwhile.
Box DiscreteSolver::room_of_ball(std::uint32_t place) const {
    const Box& now = moving_[moving_pieces() + place].box;
    const Ball& ball = (*balls_)[place];
    if (settings_.search_room == 0 || ball.asleep) return now;
    const double reach = way(ball, dt_ - span_.begin) + (1 + settings_.search_room) * ball.radius;
    return united(now, bounds_of(ball.position, reach));
}

/// The pieces within reach of a ball.
std::span<const DiscreteSolver::Candidate> DiscreteSolver::look_around(const Ball& ball, double reach) {
    const Box box = bounds_of(ball.position, ball.radius + reach);
    const Proxy proxy{box, ball.layer, ball.collides_with, true, true};
    const std::vector<Proxy>& still = layout_.still_proxies();
    around_.clear();
    found_.clear();
    broad_->find_overlapping(box, found_);
    for (const Handle i : found_)
        if (i < still.size() && may_meet(proxy, still[i])) around_.push_back({0, i});
    std::ranges::sort(around_, {}, &Candidate::piece);
    // Of what moves, the broad phase may know an earlier place.
    for (auto i = static_cast<PieceIndex>(still.size()); i < layout_.size(); ++i) {
        const Proxy& other = moving_[i - still.size()];
        if (!may_meet(proxy, other)) continue;
        ++record_->statistics.pair_tests;
        if (overlap(box, other.box)) around_.push_back({0, i});
    }
    return around_;
}

/// When the ball, flying freely from `at` seconds into this motion iteration, first touches a piece in
/// such a way that it would sink in deep; else never.
double DiscreteSolver::first_touch_of(const Ball& ball, PieceIndex index, double at, double duration) const {
    const Piece& piece = layout_.piece(index);
    const double begin = span_.begin + at;
    const Pose pose = layout_.pose(*table_, index, begin);
    const double rate = layout_.rate(*table_, index, begin);
    const double own = length(ball.velocity) + pull_ * duration;
    const double speed = own + std::abs(rate) * (length(ball.position - pose.pivot) + own * duration);
    if (!sinks(speed, ball, duration) || !layout_.stops(*table_, index, pose, ball)) return never;

    std::uint64_t& tests = record_->statistics.narrow_tests;
    const auto touch_at = [&](double time, Ball& flying) {
        flying = ball;
        fly_freely(flying, scene_.gravity, Stretch(scene_.damping, time));
        ++tests;
        return touch(flying.position, flying.radius, piece,
                     rate != 0 ? table_->pose(piece.part, begin + time) : pose);
    };
    Ball flying = ball;
    const double time = first_touch([&](double t) { return touch_at(t, flying).separation; }, speed, duration,
                                    stop_distance * ball.radius);
    if (time == never) return never;
    const Touch met = touch_at(time, flying);
    if (met.past_end && gate_of(scene_.parts[piece.part]) != nullptr) return never;
    const Vec2 surface = cross(layout_.rate(*table_, index, begin + time), met.point - pose.pivot);
    const double approach = -dot(flying.velocity - surface, met.normal);
    return sinks(approach, ball, duration) ? time : never;
}

/// A closed gate opens for a ball that flew in from behind, and an open one stays so while any is in it.
void DiscreteSolver::watch_gates() {
    for (const PartIndex part : gates_) {
        const shape::Gate& gate = *gate_of(scene_.parts[part]);
        bool occupied = false;
        for (const Candidate& candidate : candidates_) {
            const Piece& piece = layout_.piece(candidate.piece);
            if (piece.part != part) continue;
            const Ball& ball = (*balls_)[candidate.ball];
            const Pose before = table_->pose(part, span_.begin), now = table_->pose(part, span_.end);
            ++record_->statistics.narrow_tests;
            const Touch found = touch(ball.position, ball.radius, piece, now);
            const Vec2 came_from = before.undo(started_[candidate.ball]);
            const bool let_through = table_->parts()[part].open || dot(came_from - gate.a, gate.normal) <= 0;
            if (let_through && !found.past_end && found.separation < 0) occupied = true;
        }
        table_->set_open(part, occupied);
    }
}

/// Sensors note what crossed them on its way.
void DiscreteSolver::watch_sensors() {
    if (!any_sensor_) return;
    for (const Candidate& candidate : candidates_) {
        const Piece& piece = layout_.piece(candidate.piece);
        if (!scene_.parts[piece.part].sensor) continue;
        const Ball& ball = (*balls_)[candidate.ball];
        const Pose pose = table_->pose(piece.part, span_.end);
        const Vec2 from = started_[candidate.ball], way = ball.position - from;
        const auto separation = [&](double t) {
            ++record_->statistics.narrow_tests;
            return touch(from + t * way, ball.radius, piece, pose).separation;
        };
        if (first_touch(separation, length(way), 1, 0) != never)
            record_->crossed.push_back({ball.number, piece.part});
    }
}

}  // namespace flipside::custom

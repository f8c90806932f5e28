#include "custom/discrete/discrete_solver.hpp"

#include <algorithm>
#include <chrono>

#include "custom/flight.hpp"
#include "custom/geometry/sweep.hpp"

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
      near_(layout.still_proxies()) {
    for (PartIndex i = 0; i < scene.parts.size(); ++i)
        if (gate_of(scene.parts[i]) != nullptr) gates_.push_back(i);
}

void DiscreteSolver::reserve(std::size_t balls) {
    make_room(moving_, layout_.size() + balls);
    make_room(started_, balls);
    make_room(candidates_, balls, contacts_per_ball);
    make_room(ball_pairs_, balls, contacts_per_ball);
    make_room(supports_, balls, contacts_per_ball);
    make_room(around_, layout_.size());
    make_room(deep_, layout_.size());
    make_room(changed_in_, balls);
    make_room(flown_, balls);
    for (auto* marks : {&stirred_, &in_heap_, &borne_}) make_room(*marks, balls);
}

void DiscreteSolver::step(Table& table, std::vector<Ball>& balls, double dt, BroadPhase& broad,
                          StepRecord& record) {
    table_ = &table, balls_ = &balls, record_ = &record, dt_ = dt;
    const int iterations = settings_.motion_iterations;
    const double flight = dt / iterations;
    Stopwatch watch;
    for (int i = 0; i < iterations; ++i) {
        span_ = {i * flight, i + 1 == iterations ? dt : (i + 1) * flight};
        find_candidates(span_.duration(), broad);
        watch.lap(record.broad_seconds);
        fly_all(span_.duration());
        watch.lap(record.flight_seconds);
        watch_gates();
        collide();
        watch_sensors();
        watch.lap(record.contact_seconds);
        ++record.statistics.substeps;
    }
}

/// The farthest a ball can get.
double DiscreteSolver::way(const Ball& ball, double duration) const {
    return (length(ball.velocity) + pull_ * duration) * duration;
}

void DiscreteSolver::find_candidates(double duration, BroadPhase& broad) {
    const Stretch stretch(scene_.damping, duration);
    const auto box_of = [&](const Ball& ball) {
        const Box here = bounds_of(ball.position, ball.radius);
        if (ball.asleep) return here;
        // A fast ball may be turned round in mid-flight, so it can end anywhere within its reach.
        const double reach = way(ball, duration);
        if (reach > settings_.sweep_from * ball.radius) return grown(here, reach);
        return united(here, bounds_of(end_of_flight(ball, scene_.gravity, stretch), ball.radius));
    };
    std::vector<Ball>& balls = *balls_;
    layout_.place(*table_, balls, span_.begin, span_.end, false, box_of, moving_);
    near_.find_pairs(
        moving_, broad, [&](std::size_t i) { return room_of(i); }, pairs_);

    candidates_.clear();
    ball_pairs_.clear();
    for (const Pair pair : pairs_) {
        const std::uint32_t b = pair.b - layout_.size();
        if (pair.a >= layout_.size()) {
            ball_pairs_.push_back({pair.a - layout_.size(), b});
            continue;
        }
        balls[b].asleep = false;  // only a part in motion is paired with a sleeper
        candidates_.push_back({b, pair.a});
    }
}

void DiscreteSolver::fly_all(double duration) {
    std::vector<Ball>& balls = *balls_;
    const Stretch stretch(scene_.damping, duration);
    started_.clear();
    flown_.assign(balls.size(), duration);
    auto next = candidates_.begin();
    for (std::uint32_t i = 0; i < balls.size(); ++i) {
        started_.push_back(balls[i].position);
        const auto first = next;
        while (next != candidates_.end() && next->ball == i) ++next;
        if (balls[i].asleep) continue;
        if (first == next)
            fly_freely(balls[i], scene_.gravity, stretch);
        else
            fly(balls[i], std::span<const Candidate>(first, next), duration);
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

/// Where a moving proxy may get until the end of the step, with some room for what hits it meanwhile.
Box DiscreteSolver::room_of(std::size_t moving) const {
    const Box now = moving_[moving].box;
    if (settings_.search_room == 0) return now;
    const PieceIndex pieces = layout_.size() - static_cast<PieceIndex>(layout_.still_proxies().size());
    if (moving < pieces) {
        const auto piece = static_cast<PieceIndex>(layout_.still_proxies().size() + moving);
        return united(now, layout_.proxy(*table_, piece, span_.begin, dt_).box);
    }
    const Ball& ball = (*balls_)[moving - pieces];
    if (ball.asleep) return now;
    const double left = dt_ - span_.begin;
    const Vec2 end = end_of_flight(ball, scene_.gravity, Stretch(scene_.damping, left));
    const Box way = united(bounds_of(ball.position, ball.radius), bounds_of(end, ball.radius));
    return united(now, grown(way, settings_.search_room * ball.radius));
}

/// The pieces within reach of a ball, by testing all of them where the list of near ones does not do.
std::span<const DiscreteSolver::Candidate> DiscreteSolver::look_around(const Ball& ball, double reach) {
    const Box box = bounds_of(ball.position, ball.radius + reach);
    const Proxy proxy{box, ball.layer, ball.collides_with, true, true};
    const std::vector<Proxy>& still = layout_.still_proxies();
    around_.clear();
    const auto look_at = [&](PieceIndex i) {
        const Proxy& other = layout_.moves(i) ? moving_[i - still.size()] : still[i];
        if (!may_meet(proxy, other)) return;
        ++record_->statistics.pair_tests;
        if (overlap(box, other.box)) around_.push_back({0, i});
    };
    const std::size_t place =
        moving_.size() - balls_->size() + static_cast<std::size_t>(&ball - balls_->data());
    const Box& room = near_.room(place);
    if (room.contains(box.min) && room.contains(box.max)) {
        for (const Pair pair : near_.listed(place))
            if (pair.a < layout_.size()) look_at(pair.a);
    } else {
        for (PieceIndex i = 0; i < layout_.size(); ++i) look_at(i);
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

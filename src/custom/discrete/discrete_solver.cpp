#include "custom/discrete/discrete_solver.hpp"

#include <algorithm>

#include "custom/broad_phase/room.hpp"
#include "custom/decide_gate.hpp"
#include "custom/flight.hpp"
#include "custom/geometry/sweep.hpp"
#include "custom/sift.hpp"
#include "custom/stopwatch.hpp"

namespace flipside::custom {

namespace {

/// A swept ball stops this near to a surface, in radii.
constexpr double stop_distance = 1e-7;

}  // namespace

DiscreteSolver::DiscreteSolver(const Scene& scene, const Layout& layout, const SolverSettings& settings)
    : scene_(scene),
      layout_(layout),
      settings_(settings),
      pull_(length(scene.gravity)),
      any_sensor_(std::ranges::any_of(scene.parts, &Part::sensor)),
      near_(layout.still_proxies()) {}

void DiscreteSolver::reserve(std::size_t balls) {
    make_room(moving_, layout_.size() + balls);
    make_room(so_far_, balls);
    make_room(rounds_, balls);
    waiting_.reserve(balls);
    all_engaged_.reserve(balls);
    for (auto* room : {&candidate_room_, &touching_room_}) make_room(*room, balls, pairs_per_ball);
    make_room(near_balls_room_, balls, pairs_per_ball);
    make_room(around_, layout_.size());
    make_room(found_, layout_.size() + balls);
    make_room(role_, balls);
    make_room(first_link_, balls);
    make_room(links_, balls, 2 * pairs_per_ball);
    make_room(meetings_, balls, pairs_per_ball);
    make_room(turns_, balls, pairs_per_ball);
    make_room(turn_room_, sift_block);
    make_room(pair_places_, balls, pairs_per_ball);
    for (auto* places : {&engaged_, &dozing_, &seeking_, &places_}) make_room(*places, balls, 1);
    for (auto* pairs : {&part_pairs_, &ball_pairs_, &fresh_part_pairs_, &fresh_ball_pairs_, &room_})
        make_room(*pairs, balls, pairs_per_ball);
    near_.reserve(layout_.size() + balls, balls);
    make_room(deep_, layout_.size());
    make_room(pressing_, balls, contacts_per_ball);
    make_room(pressed_, balls, contacts_per_ball);
    strays_.reserve(balls);
    pile_.reserve(balls);
    make_room(marks_, static_cast<std::size_t>(settings_.motion_iterations) + 1);
}

void DiscreteSolver::step(Table& table, std::vector<Ball>& balls, double dt, BroadPhase& broad,
                          StepRecord& record) {
    table_ = &table, balls_ = &balls, record_ = &record, broad_ = &broad, dt_ = dt;
    const int iterations = settings_.motion_iterations;
    const double flight = dt / iterations;
    marks_.clear();
    for (int i = 0; i < iterations; ++i) marks_.emplace_back(scene_.damping, i * flight);
    marks_.emplace_back(scene_.damping, dt);
    flight_ = Stretch(scene_.damping, flight);
    Stopwatch watch;
    find_turns();
    watch.lap(record.broad_seconds);
    for (std::size_t i = 0; i < flights(); ++i) {
        span_ = {marks_[i].time, marks_[i + 1].time};
        start_flights(i);
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
    finish_step();
    watch.lap(record.flight_seconds);
}

/// Flies the engaged balls that no part can stop in mid-flight, because they are slow and only still parts
/// are near; the others wait. Notes for all in which box they stay.
void DiscreteSolver::start_flights(std::size_t flight) {
    const PieceIndex first = moving_pieces();
    swept_.reset();
    for (PieceIndex i = 0; i < first; ++i) {
        moving_[i] = layout_.proxy(*table_, layout_.size() - first + i, span_.begin, span_.end);
        const Box box = moving_[i].box;
        swept_ = swept_ ? united(*swept_, box) : box;
    }
    waiting_.start(balls_->size());
    engage_due(flight);
    all_engaged_.list(places_);
    each_prepared(
        places_, [&](std::uint32_t soon) { prepare(soon); },
        [&](std::uint32_t place) { start_flight(place); });
    engage_met();
}

void DiscreteSolver::start_flight(std::uint32_t place) {
    Ball& ball = (*balls_)[place];
    start_over(place);
    if (ball.asleep) return;
    SoFar& so_far = so_far_[place];
    const double radius = ball.radius, duration = flight_.time;
    const Vec2 here = ball.position, there = end_of_flight(ball, scene_.gravity, flight_);
    // What may sink in deep: way(ball, duration) > deep, without the root. It may be turned round in
    // mid-flight then, so it can end anywhere within its reach.
    const double slow = settings_.sweep_from * radius - pull_ * duration * duration;
    const bool fast = (slow < 0) | (length_squared(ball.velocity) * duration * duration > slow * slow);
    Box box{{std::min(here.x, there.x) - radius, std::min(here.y, there.y) - radius},
            {std::max(here.x, there.x) + radius, std::max(here.y, there.y) + radius}};
    if (fast) box = bounds_of(here, radius + way(ball, duration));
    so_far.box = box;
    if (!(so_far.is_known & holds(so_far.reach, so_far.box))) widen(place, box);
    if (fast || (swept_ && overlap(*swept_, box)))
        waiting_.add(place);
    else
        fly_freely(ball, scene_.gravity, flight_);
}

/// Of a ball in this flight: nothing happened yet.
void DiscreteSolver::start_over(std::uint32_t place) {
    SoFar& so_far = so_far_[place];
    so_far.start = (*balls_)[place].position;
    so_far.flown = span_.duration();
    rounds_[place] = {};
}

/// Pairs of those that are engaged by now whose boxes overlap in this flight.
void DiscreteSolver::find_candidates() {
    const auto is_engaged = [&](Pair pair) { return role_[place_of(pair.b)] == Role::engaged; };
    const auto as_candidate = [&](Pair pair) { return Candidate{place_of(pair.b), pair.a}; };
    const auto of_engaged = sift(part_pairs_, candidate_room_, is_engaged, Nothing{}, as_candidate);
    candidates_ = sift(
        of_engaged, candidate_room_,
        [&](const Candidate& c) { return overlap(proxy_of(c.piece).box, so_far_[c.ball].box); },
        [&](const Candidate& c) { fetch(proxy_of(c.piece)); });
    const auto between_engaged = sift(
        ball_pairs_, near_balls_room_,
        [&](Pair pair) { return (roles_of(pair) & (Role::free | Role::engaged)) == Role::engaged; },
        Nothing{}, [&](Pair pair) { return places_of(pair); });
    near_balls_ = sift(between_engaged, near_balls_room_,
                       [&](BallPair pair) { return overlap(so_far_[pair.a].box, so_far_[pair.b].box); });
    record_->statistics.pair_tests += of_engaged.size() + between_engaged.size();
    if (!any_asleep_) return;
    std::vector<Ball>& balls = *balls_;
    for (const auto [b, piece] : candidates_) {
        if (!balls[b].asleep) continue;
        balls[b].asleep = false;  // only a part in motion is paired with a sleeper
        waiting_.add(b);
    }
}

/// Flies those that wait.
void DiscreteSolver::finish_flights(double duration) {
    auto next = candidates_.begin();
    waiting_.list(places_);
    each_prepared(
        places_, [&](std::uint32_t soon) { fetch_flight((*balls_)[soon]); },
        [&](std::uint32_t place) {
            next = std::find_if(next, candidates_.end(), [&](const Candidate& c) { return c.ball >= place; });
            const auto last =
                std::find_if(next, candidates_.end(), [&](const Candidate& c) { return c.ball > place; });
            fly((*balls_)[place], {next, last}, duration);
            next = last;
        });
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
        so_far_[static_cast<std::size_t>(&ball - balls_->data())].flown = duration - at;
        // Kicked faster, it leaves the surroundings that were searched for parts.
        if (way(ball, duration) > searched) {
            searched = way(ball, duration);
            near = look_around(ball, searched);
        }
    }
}

/// The pieces within reach of a ball.
std::span<const DiscreteSolver::Candidate> DiscreteSolver::look_around(const Ball& ball, double reach) {
    const Box box = bounds_of(ball.position, ball.radius + reach);
    const Proxy proxy{box, ball.layer, ball.collides_with, true, true};
    const std::vector<Proxy>& still = layout_.still_proxies();
    around_.clear();
    found_.clear();
    broad_->find_overlapping(proxy.box, found_);
    for (const Handle i : found_)
        if (i < still.size() && may_meet(proxy, still[i])) around_.push_back({0, i});
    std::ranges::sort(around_, {}, &Candidate::piece);
    // Of what moves, the broad phase may know an earlier place.
    for (auto i = static_cast<PieceIndex>(still.size()); i < layout_.size(); ++i) {
        const Proxy& other = moving_[i - still.size()];
        if (!may_meet(proxy, other)) continue;
        ++record_->statistics.pair_tests;
        if (overlap(proxy.box, other.box)) around_.push_back({0, i});
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

/// Balls that a closed gate meets are blocked by it, or open it, by the side on which they were before they
/// flew into it; an open one stays so while any is in it.
void DiscreteSolver::watch_gates() {
    for (const PartIndex part : layout_.gates())
        decide_gate(*table_, part, span_.begin, span_.end, *balls_, record_->statistics.narrow_tests,
                    [&](auto&& visit) {
                        for (const Candidate& candidate : candidates_)
                            if (layout_.piece(candidate.piece).part == part)
                                visit((*balls_)[candidate.ball], so_far_[candidate.ball].start);
                    });
}

/// Sensors note what crossed them on its way.
void DiscreteSolver::watch_sensors() {
    if (!any_sensor_) return;
    for (const Candidate& candidate : candidates_) {
        const Piece& piece = layout_.piece(candidate.piece);
        if (!scene_.parts[piece.part].sensor) continue;
        const Ball& ball = (*balls_)[candidate.ball];
        const Pose pose = table_->pose(piece.part, span_.end);
        const Vec2 from = so_far_[candidate.ball].start, way = ball.position - from;
        const auto separation = [&](double t) {
            ++record_->statistics.narrow_tests;
            return touch(from + t * way, ball.radius, piece, pose).separation;
        };
        if (first_touch(separation, length(way), 1, 0) != never)
            record_->crossed.push_back({ball.number, piece.part});
    }
}

}  // namespace flipside::custom

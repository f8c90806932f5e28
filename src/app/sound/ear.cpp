#include "app/sound/ear.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/window/camera.hpp"

namespace flipside::app::sound {

namespace {

constexpr double same_time = 1e-9;  ///< s
constexpr int most_ticks = 8;       ///< of a spinner in one step

/// Of the ball by a hit, m/s; where the engine tells no impulse, as if it stuck.
double change_of_speed(const Event& event, const Ball* ball) {
    const double told = ball != nullptr ? event.impulse / ball->mass : 0;
    return std::max(told, event.speed);
}

double middle(const Box& box) {
    return 0.5 * (box.min.x + box.max.x);
}

}  // namespace

double Ear::place(double x) const {
    const Box& view = view_bounds(*scene_);
    return std::clamp((x - middle(view)) / (0.5 * (view.max.x - view.min.x)), -1.0, 1.0);
}

void Ear::add(double time, Source source, double strength, double x, double pitch) {
    heard_.push_back({time, {source, strength, pitch, 0, 1, place(x)}});
}

void Ear::begin(const lab::Session& session) {
    if (scene_ == session.shared_scene()) return;
    scene_ = session.shared_scene();
    parts_ = part_sounds(*scene_);
    before_ = {};
}

std::span<const Heard> Ear::listen(const lab::Session& session, std::span<const Event> events, double from) {
    begin(session);
    heard_.clear();
    hear_events(session, events);
    if (std::abs(before_.time - from) <= same_time) {
        hear_flippers(session, from);
        if (scene_->launcher) hear_launches(session, events, from);
        if (scene_->rules) {
            hear_spinners(session, from);
            hear_rules(session);
        }
    }
    remember(session);
    return heard_;
}

void Ear::remember(const lab::Session& session) {
    const World& world = session.world();
    const auto balls = world.balls();
    const auto parts = world.parts();
    before_.moving.resize(parts.size());
    for (std::size_t i = 0; i < parts.size(); ++i)
        before_.moving[i] = i < before_.parts.size() && parts[i].angle != before_.parts[i].angle;
    before_.time = world.time();
    before_.told = session.game().told();
    before_.balls.assign(balls.begin(), balls.end());
    before_.parts.assign(parts.begin(), parts.end());
    before_.spins.clear();
    if (!scene_->rules) return;
    for (const Rules::Spinner& spinner : scene_->rules->spinners)
        before_.spins.push_back(session.game().spinning(spinner.part));
}

void Ear::hear_events(const lab::Session& session, std::span<const Event> events) {
    for (const Event& event : events) {
        const Ball* ball = find_ball(session.world().balls(), event.ball);
        if (ball == nullptr) ball = find_ball(before_.balls, event.ball);  // it has just left
        if (event.kind == EventKind::lost) add(event.time, Source::drain, 1, event.point.x);
        if (event.kind != EventKind::impact && event.kind != EventKind::sensor_begin) continue;
        const double strength = change_of_speed(event, ball), where = place(event.point.x);
        if (event.other.is_ball) {
            const double size = ball != nullptr ? 2 * ball->radius : timbre_of(Source::ball).size;
            add(event.time, Source::ball, strength, event.point.x, pitch_of_size(size, Source::ball));
        } else {
            const PartSound& part = parts_[event.other.index];
            const double pressed =
                part.source == Source::rollover && ball != nullptr ? length(ball->velocity) : strength;
            heard_.push_back(
                {event.time, {part.source, pressed, part.pitch, part.friction, part.restitution, where}});
        }
    }
}

/// The coil as it sets off, and the stop.
void Ear::hear_flippers(const lab::Session& session, double from) {
    const auto now = session.world().parts();
    for (std::size_t i = 0; i < now.size(); ++i) {
        const auto* flip = std::get_if<motion::Flip>(&scene_->parts[i].motion);
        if (flip == nullptr) continue;
        const auto& flipper = std::get<shape::Flipper>(scene_->parts[i].shape.is);
        const bool moves = now[i].angle != before_.parts[i].angle;
        if (moves == before_.moving[i]) continue;
        // Angles are from the one at rest.
        const bool up = moves ? std::abs(now[i].angle) > std::abs(before_.parts[i].angle) : now[i].angle != 0;
        const double rate = up ? flip->up_rate : flip->down_rate;
        add(from, Source::coil, 0.5 * flipper.length * rate, flipper.pivot.x, moves ? 1 : 1.3);
    }
}

/// A ball that leaves the launcher faster than it was, and has not hit anything.
void Ear::hear_launches(const lab::Session& session, std::span<const Event> events, double from) {
    const Launcher& launcher = *scene_->launcher;
    const double span = session.world().time() - from;
    for (const Ball& ball : session.world().balls()) {
        const double speed = dot(ball.velocity, launcher.direction);
        if (speed <= 0 || speed < 0.9 * launcher.slowest ||
            length(ball.position - launcher.position) > ball.radius + speed * span)
            continue;
        const Ball* earlier = find_ball(before_.balls, ball.number);
        const double gained = earlier ? speed - dot(earlier->velocity, launcher.direction) : speed;
        const bool hit = std::ranges::any_of(events, [&](const Event& event) {
            return event.kind == EventKind::impact &&
                   (event.ball == ball.number || event.other == Other::ball(ball.number));
        });
        if (!hit && gained > 0.5 * launcher.slowest) add(from, Source::launch, gained, launcher.position.x);
    }
}

/// A tick for every half turn.
void Ear::hear_spinners(const lab::Session& session, double from) {
    const auto& spinners = scene_->rules->spinners;
    for (std::size_t i = 0; i < spinners.size(); ++i) {
        const double now = session.game().spinning(spinners[i].part);
        const int ticks =
            std::min(most_ticks, static_cast<int>(std::floor(before_.spins[i]) - std::floor(now)));
        const double span = session.world().time() - from;
        for (int tick = 0; tick < ticks; ++tick)
            add(from + span * tick / ticks, Source::rollover, 0.8, middle(view_bounds(*scene_)), 0.8);
    }
}

/// A tilt, and what pays a bonus: once, however many come in one step.
void Ear::hear_rules(const lab::Session& session) {
    const std::vector<lab::Caption>& captions = session.game().captions();
    const std::size_t told = session.game().told();
    const std::size_t fresh = told > before_.told ? std::min(told - before_.told, captions.size()) : 0;
    const auto hear = [&](Source source, std::initializer_list<lab::CaptionKind> kinds) {
        for (const lab::Caption& caption : std::span(captions).last(fresh))
            if (std::ranges::find(kinds, caption.kind) != kinds.end())
                return add(caption.time, source, 1, middle(view_bounds(*scene_)));
    };
    using Kind = lab::CaptionKind;
    hear(Source::tilt, {Kind::tilt});
    hear(Source::bonus,
         {Kind::lanes_complete, Kind::bank_complete, Kind::skill_shot, Kind::jackpot, Kind::bonus});
}

Roll Ear::roll(const lab::Session& session) const {
    const World& world = session.world();
    const Scene& scene = session.scene();
    double squares = 0, moment = 0;
    const auto count = [&](const Ball& ball) {
        const double square = length_squared(ball.velocity);
        squares += square;
        moment += square * ball.position.x;
    };
    if (scene.damping > 0) {
        for (const Ball& ball : world.balls()) count(ball);
    } else {
        BallNumber last = ~BallNumber{0};
        for (const Contact& contact : world.contacts())
            if (const Ball* ball = find_ball(world.balls(), contact.ball);
                ball != nullptr && std::exchange(last, ball->number) != ball->number)
                count(*ball);
    }
    if (squares == 0 || !scene_) return {};
    return {std::sqrt(squares), place(moment / squares), 1};
}

}  // namespace flipside::app::sound

/// One step of a foreign engine's world: what it is told, and what is taken of what it answers.

#include <algorithm>
#include <tuple>

#include "plugin/engine.hpp"
#include "plugin/handover.hpp"
#include "plugin/world.hpp"

namespace flipside::plugin {

namespace {

/// Of a step's length: so far beyond its ends the time of an event may lie, by rounding.
constexpr double time_slack = 1e-6;

Vec2 ours(flipside_vec v) {
    return {v.x, v.y};
}

bool is_number(const flipside_ball_state& ball) {
    return is_finite(ours(ball.position)) && is_finite(ours(ball.velocity)) && std::isfinite(ball.angle) &&
           std::isfinite(ball.spin);
}

std::string ball_name(std::uint32_t number) {
    return "ball " + std::to_string(number);
}

}  // namespace

void PluginWorld::make_step(double dt) {
    launch();
    const std::vector<Ball> before = trace_ ? balls_ : std::vector<Ball>();
    const std::size_t changes = changes_.size();
    if (stale_) make();
    note_motions(table_, motions_);
    const auto ask_for_step = [&] {
        Writer out(question_);
        out.array(std::span(std::as_const(changes_)));
        out.array(std::span(std::as_const(motions_)));
        out.value(table_.time());
        out.value(dt);
        out.value(static_cast<std::uint64_t>(balls_.size()));
        return ask(Ask::step);
    };
    Answer answer = ask_for_step();
    if (answer == Answer::not_followed) {
        make();
        answer = ask_for_step();
    }
    if (answer != Answer::done) refuse("follows no controls, not even in a new world");
    changes_.clear();
    take_answer(dt);
    if (trace_) trace_step(before, dt, changes);
}

void PluginWorld::launch() {
    while (const auto launched = table_.launch(balls_)) {
        if (launched->existing) {
            *find(launched->ball.number) = launched->ball;
            change(FLIPSIDE_SET_BALL, launched->ball);
        } else {
            add(launched->ball);
        }
    }
}

void PluginWorld::take_answer(double dt) {
    const double start = table_.time();
    double cpu_seconds = 0;
    try {
        Reader in(answer_);
        cpu_seconds = in.value<double>();
        in.array(moved_);
        in.array(foreign_events_);
        in.array(foreign_contacts_);
        in.finish();
    } catch (const Malformed& problem) {
        process_.reset();
        refuse(std::string("its process answers nonsense (") + problem.what() + ")");
    }
    take_balls(moved_);
    table_.advance(dt);
    take_events(foreign_events_, start);
    take_contacts(foreign_contacts_);
    report_lost();
    measure(cpu_seconds);
}

void PluginWorld::take_balls(std::span<const flipside_ball_state> moved) {
    std::ranges::sort(moved_, {}, &flipside_ball_state::number);
    if (moved.size() != balls_.size())
        refuse("gives " + counted(moved.size(), "ball") + "; there are " + std::to_string(balls_.size()));
    for (std::size_t i = 0; i < balls_.size(); ++i) {
        Ball& ball = balls_[i];
        const flipside_ball_state& now = moved[i];
        if (now.number != ball.number)
            refuse("gives a " + ball_name(now.number) + ", where there is a " + ball_name(ball.number));
        if (!is_number(now))
            refuse(ball_name(ball.number) +
                   " has a place, velocity, angle or spin that is no number, after the step from " +
                   brief(table_.time()) + " s");
        if (now.asleep > 1)
            refuse(ball_name(ball.number) + " is asleep by " + std::to_string(now.asleep) +
                   "; allowed are 0 and 1");
        ball.position = ours(now.position);
        ball.velocity = ours(now.velocity);
        ball.angle = now.angle;
        ball.spin = now.spin;
        ball.asleep = now.asleep == 1;
    }
    require_limits(plugin_.name, balls_, table_.time());
}

Other PluginWorld::other_of(std::uint32_t is_ball, std::uint32_t index, std::uint32_t ball,
                            const char* what) const {
    if (!is_there(ball))
        refuse(std::string("gives ") + what + " of a " + ball_name(ball) + ", which is not there");
    if (is_ball == 0 && index < table_.parts().size()) return Other::part(index);
    if (is_ball == 1 && is_there(index) && ball < index) return Other::ball(index);
    refuse(std::string("gives ") + what + " of " + ball_name(ball) + " with " +
           (is_ball == 0   ? "part "
            : is_ball == 1 ? "ball "
                           : "what is neither ball nor part, ") +
           std::to_string(index) + "; allowed are parts of the scene and balls of higher numbers");
}

void PluginWorld::take_events(std::span<const flipside_event> events, double start) {
    events_.clear();
    const double slack = time_slack * (time() - start);
    double last = start - slack;
    for (const flipside_event& event : events) {
        const Other other = other_of(event.other_is_ball, event.other, event.ball, "an event");
        if (!(event.time >= last && event.time <= time() + slack))
            refuse("gives an event at " + brief(event.time) + " s in the step from " + brief(start) + " to " +
                   brief(time()) + " s; allowed are times in it, in order");
        last = event.time;
        if (take_gate(event)) continue;
        if (event.kind > FLIPSIDE_SENSOR_END)
            refuse("gives an event of kind " + std::to_string(event.kind) + ", which there is not");
        const Event taken{event.time,        static_cast<EventKind>(event.kind),
                          event.ball,        other,
                          ours(event.point), ours(event.normal),
                          event.speed,       event.impulse};
        require_finite(plugin_.name, taken, table_.scene());
        if (event.speed < 0 || event.impulse < 0)
            refuse("gives an event of " + ball_name(event.ball) + " with a speed or impulse below 0");
        events_.push_back(taken);
        const bool on_target = !other.is_ball && table_.scene().parts[other.index].target;
        if (taken.kind != EventKind::impact || !on_target || table_.parts()[other.index].down) continue;
        table_.set_down(other.index, true);
        show(other.index, false);
    }
}

/// What an engine says of gates is no event of the world's.
bool PluginWorld::take_gate(const flipside_event& event) {
    if (event.kind < FLIPSIDE_GATE_OPENED || event.kind > FLIPSIDE_GATE_LEFT) return false;
    if (event.other_is_ball != 0 || !gate_of(table_.scene().parts[event.other]))
        refuse("gives an event of a gate for what is no gate");
    if (event.kind == FLIPSIDE_GATE_OPENED || event.kind == FLIPSIDE_GATE_CLOSED)
        table_.set_open(event.other, event.kind == FLIPSIDE_GATE_OPENED);
    else
        table_.set_blocked(event.other, event.ball, event.kind == FLIPSIDE_GATE_BLOCKED);
    return true;
}

void PluginWorld::take_contacts(std::span<const flipside_contact> contacts) {
    contacts_.clear();
    for (const flipside_contact& contact : contacts) {
        contacts_.push_back({contact.ball,
                             other_of(contact.other_is_ball, contact.other, contact.ball, "a contact"),
                             ours(contact.point), ours(contact.normal), contact.separation});
        if (!is_finite(contacts_.back().point) || !is_finite(contacts_.back().normal) ||
            !std::isfinite(contact.separation))
            refuse("gives a contact of " + ball_name(contact.ball) + " with what is no number");
    }
    std::ranges::sort(contacts_, std::less{}, [](const Contact& c) {
        return std::tuple(c.ball, c.other, c.separation, c.point.x, c.point.y);
    });
}

void PluginWorld::report_lost() {
    const Scene& scene = table_.scene();
    table_.report_lost(balls_, events_);
    for (std::size_t i = scene.keep_lost ? balls_.size() : 0; i < balls_.size();) {
        const BallNumber number = balls_[i].number;
        if (scene.bounds.contains(balls_[i].position)) {
            ++i;
        } else {
            remove(number);
            std::erase_if(contacts_, [&](const Contact& contact) {
                return contact.ball == number || contact.other == Other::ball(number);
            });
        }
    }
}

void PluginWorld::measure(double cpu_seconds) {
    statistics_ = {};
    statistics_.cpu_seconds = cpu_seconds;
    statistics_.contacts = contacts_.size();
    statistics_.impacts =
        static_cast<std::uint64_t>(std::ranges::count(events_, EventKind::impact, &Event::kind));
    statistics_.asleep = static_cast<std::uint64_t>(std::ranges::count(balls_, true, &Ball::asleep));
    statistics_.stages[0] = {"step", cpu_seconds};
}

void PluginWorld::trace_step(std::span<const Ball> before, double dt, std::size_t changes) {
    trace_->stages.clear();
    TraceStage& told =
        trace_->stage("what the engine is told", "src/plugin/step.cpp: PluginWorld::make_step");
    told.says = counted(changes, "change") + " from outside since the last step, " +
                counted(motions_.size(), "moving part") + ", and to advance by " + brief(1e3 * dt) + " ms.";
    for (const flipside_motion& motion : motions_)
        told.add("motion")
            .with_other(Other::part(motion.part), table_.scene())
            .with("angle", motion.angle)
            .with("rate", motion.rate);
    TraceStage& stage = trace_->stage("the engine's step", "a library of its own: flipside_engine.step");
    stage.says = "Not visible from outside: places and velocities before and after are what there is to see.";
    for (const Ball& old : before) {
        const auto now = std::ranges::find(moved_, old.number, &flipside_ball_state::number);
        stage.add("ball")
            .with("ball", old.number)
            .with("position_before", old.position)
            .with("velocity_before", old.velocity)
            .with("position", ours(now->position))
            .with("velocity", ours(now->velocity));
    }
    trace_read_out(*trace_, "src/plugin/step.cpp: PluginWorld::take_answer", *this, table_.scene());
}

}  // namespace flipside::plugin

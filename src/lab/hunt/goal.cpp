#include "lab/hunt/goal.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <utility>

#include "lab/contenders/engines.hpp"
#include "lab/session/session.hpp"
#include "lab/session/timeline.hpp"
#include "world/input_error.hpp"
#include "world/refusal.hpp"

namespace flipside::lab::hunt {

namespace {

/// A run that has made so many is dear enough; each takes some 10 ns.
constexpr double most_tests = 1e7;

std::string name_of(const Other& other, const Scene& scene) {
    return other.is_ball ? "ball " + std::to_string(other.index) : scene.parts[other.index].name;
}

std::unique_ptr<World> make(const Engine& engine, const Settings& settings, const Scene& scene) {
    return engine.make(std::make_shared<const Scene>(scene), settings);
}

/// Calls see(time) after each step; what it returns false for is the end. False where a world refused to go
/// on.
bool run(std::span<World* const> worlds, double dt, double seconds, const std::function<bool(double)>& see) {
    const Timeline timeline(0, seconds, dt);
    bool up = false;
    double time = 0;
    for (std::uint64_t k = 0; k < timeline.steps(); ++k) {
        if (!std::exchange(up, up || 3 * time >= seconds) && up)
            for (World* world : worlds) world->apply(control::Flip{Side::left, true});
        try {
            for (World* world : worlds) world->step(timeline.length(k));
        } catch (const Refusal&) {
            return false;
        }
        time = worlds.front()->time();
        if (!see(time)) return true;
    }
    return true;
}

void note(Measured& worst, double value, double time, const std::function<std::string()>& what) {
    if (!(value > worst.value)) return;
    worst = {value, time, what()};
}

/// By the engine's contacts, and between balls also by their places, of which no engine has a say.
void look_for_overlap(const World& world, const Scene& scene, double time, Measured& worst) {
    for (const Contact& contact : world.contacts()) {
        const Ball* const ball = find_ball(world.balls(), contact.ball);
        if (!ball) continue;
        double radius = ball->radius;
        if (contact.other.is_ball)
            if (const Ball* const other = find_ball(world.balls(), contact.other.index))
                radius = std::min(radius, other->radius);
        note(worst, -contact.separation / radius, time,
             [&] { return "ball " + std::to_string(contact.ball) + " in " + name_of(contact.other, scene); });
    }
    for (const Ball& a : world.balls())
        for (const Ball& b : world.balls()) {
            if (b.number <= a.number || !layers_meet(a, b)) continue;
            const double gap = length(a.position - b.position) - a.radius - b.radius;
            note(worst, -gap / std::min(a.radius, b.radius), time,
                 [&] { return "ball " + std::to_string(a.number) + " in ball " + std::to_string(b.number); });
        }
}

/// The most that the balls can have: their motion, and a fall through the whole scene. J.
double most_energy(const Scene& scene) {
    const double height = length(scene.bounds.max - scene.bounds.min);
    double sum = 0;
    for (const Ball& ball : scene.balls)
        sum += 0.5 * ball.mass * dot(ball.velocity, ball.velocity) +
               0.5 * inertia(ball) * ball.spin * ball.spin + ball.mass * length(scene.gravity) * height;
    return sum;
}

void look_for_lost(const World& world, std::size_t balls, double time, Measured& worst) {
    std::size_t there = 0;
    for (const Ball& ball : world.balls())
        there += std::isfinite(length(ball.position)) && std::isfinite(length(ball.velocity));
    note(worst, static_cast<double>(balls) - static_cast<double>(there), time,
         [&] { return std::to_string(balls - there) + " of " + std::to_string(balls) + " balls"; });
}

/// The scene with each ball shifted a little in a direction of its own: a shift of all balls alike changes no
/// collision between balls. `turned` turns all these directions by a right angle: along any line, at least
/// one of the two scenes then changes the relative position of two balls.
Scene shifted(const Scene& scene, bool turned) {
    constexpr double shift = 1e-13;       // m, and m/s
    constexpr double golden_angle = 2.4;  // rad: its multiples are far from each other
    Scene other = scene;
    double angle = 0;
    for (Ball& ball : other.balls) {
        const Vec2 along = from_angle(angle), by = shift * (turned ? perp(along) : along);
        ball.position += by;
        ball.velocity += by;
        angle += golden_angle;
    }
    return other;
}

/// Between a ball's positions in two worlds, m. Null: the world has lost it. A lost ball left the bounds, so
/// it is at least as far from the other position as their border is.
double distance(const Ball* a, const Ball* b, const Box& bounds) {
    if (a && b) return length(a->position - b->position);
    if (!a && !b) return 0;
    const Vec2 low = (a ? a : b)->position - bounds.min, high = bounds.max - (a ? a : b)->position;
    return std::min({low.x, low.y, high.x, high.y});
}

Measured measure_error(const Contender& contender, const Scene& scene, double seconds) {
    constexpr double tame = 1e-9;  // radii
    const Engine& reference = engine_named("reference");
    const Settings plain = settings_for(reference, scene);
    Settings with_twin = plain;
    with_twin.set("twin", "on");
    const auto ours = make(*contender.engine, contender.settings, scene),
               truth = make(reference, with_twin, scene);
    // They only tell how far they are from the truth: a twin beside each would cost most of the time.
    const std::unique_ptr<World> near[] = {make(reference, plain, shifted(scene, false)),
                                           make(reference, plain, shifted(scene, true))};
    World* const worlds[] = {ours.get(), truth.get(), near[0].get(), near[1].get()};
    Measured worst;
    static_cast<void>(run(worlds, contender.dt, seconds, [&](double time) {
        for (const Ball& ball : scene.balls) {
            const Ball* const right = find_ball(truth->balls(), ball.number);
            const auto off = [&](const std::unique_ptr<World>& world) {
                return distance(right, find_ball(world->balls(), ball.number), scene.bounds) / ball.radius;
            };
            // Beyond here a last digit decides.
            if (std::ranges::any_of(near, [&](const auto& world) { return off(world) > tame; }) ||
                (right && truth->uncertainty()[static_cast<std::size_t>(right - truth->balls().data())] >
                              tame * ball.radius))
                return false;
            note(worst, off(ours), time, [&] { return "ball " + std::to_string(ball.number); });
        }
        return true;
    }));
    return worst;
}

}  // namespace

Goal goal_named(std::string_view name) {
    constexpr std::pair<std::string_view, Goal> also[] = {{"lost", Goal::escape}, {"time", Goal::work}};
    const auto other = std::ranges::find(also, name, [](const auto& one) { return one.first; });
    if (other != std::end(also)) return other->second;
    const auto at = std::ranges::find(goal_names, name);
    if (at != std::end(goal_names)) return static_cast<Goal>(at - std::begin(goal_names));
    std::string known;
    for (const std::string_view one : goal_names) {
        known += (known.empty() ? "" : ", ") + std::string(one);
        for (const auto& [second, goal] : also)
            if (name_of(goal) == one) known += " or " + std::string(second);
    }
    throw InputError("unknown goal '" + std::string(name) + "'; allowed are " + known);
}

std::string_view unit_of(Goal goal) {
    switch (goal) {
        case Goal::overlap:
        case Goal::error:
            return "radii";
        case Goal::energy:
            return "of the energy that the balls can have";
        case Goal::escape:
            return "balls";
        case Goal::work:
            return "tests per ball and step";
    }
    return "";
}

bool says_something(Goal goal, const Scene& scene) {
    const bool still = std::ranges::all_of(
        scene.parts, [](const Part& part) { return std::holds_alternative<motion::Still>(part.motion); });
    const bool gives_nothing = std::ranges::all_of(
        scene.materials, [](const Material& m) { return m.restitution <= 1 && m.kick <= 0; });
    switch (goal) {
        case Goal::escape:
            return still;
        case Goal::overlap:
        case Goal::energy:
            return still && gives_nothing;
        case Goal::error:
        case Goal::work:
            return true;
    }
    return true;
}

Measured measure(Goal goal, const Contender& contender, const Scene& scene, double seconds) try {
    if (!says_something(goal, scene)) return {};
    if (goal == Goal::error) return measure_error(contender, scene, seconds);
    const auto world = make(*contender.engine, contender.settings, scene);
    World* const worlds[] = {world.get()};
    const std::size_t balls = world->balls().size();
    const double begun = energy(*world, scene), most = most_energy(scene);
    Measured worst;
    double tests = 0, steps = 0;
    static_cast<void>(run(worlds, contender.dt, seconds, [&](double time) {
        ++steps;
        const Statistics& statistics = world->statistics();
        tests += static_cast<double>(statistics.pair_tests + statistics.narrow_tests);
        if (goal == Goal::work && tests > most_tests) return false;
        if (goal == Goal::overlap) look_for_overlap(*world, scene, time, worst);
        if (goal == Goal::escape) look_for_lost(*world, balls, time, worst);
        // A ball that is lost takes its energy along, below the origin less than none.
        if (goal == Goal::energy && world->balls().size() < balls) return false;
        if (goal == Goal::energy && most > 0)
            note(worst, (energy(*world, scene) - begun) / most, time,
                 [] { return std::string("all balls"); });
        return true;
    }));
    if (goal == Goal::work && balls > 0 && steps > 0)
        return {tests / (steps * static_cast<double>(balls)), world->time(), "mean of the run"};
    return worst;
} catch (const InputError&) {
    return {};
} catch (const Refusal&) {
    return {};
}

}  // namespace flipside::lab::hunt

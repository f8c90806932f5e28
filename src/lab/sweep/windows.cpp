#include "lab/sweep/windows.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>

#include "lab/session/session.hpp"
#include "world/fnv1a.hpp"
#include "world/refusal.hpp"

namespace flipside::lab::sweep {

namespace {

/// Every trajectory is asked for this many states.
constexpr std::size_t states_each = 25;

/// The outcome of a start, or why it makes no window.
struct Found {
    Window window;
    std::string skipped;  ///< "" for a window
};

/// The worlds that windows are run in. Of two runs in double precision each rounds in its own way: by chance
/// one may end close to the exact outcome where rounding has decided.
struct Reference {
    std::unique_ptr<World> exact, in_double, again;

    [[nodiscard]] std::array<World*, 3> all() const { return {&*in_double, &*again, &*exact}; }
};

/// The same state but for the last bit of all positions and velocities.
State with_other_rounding(State state) {
    for (Ball& ball : state.balls)
        for (double* part : {&ball.position.x, &ball.position.y, &ball.velocity.x, &ball.velocity.y})
            if (*part != 0) *part = std::nextafter(*part, ball.number % 2 == 0 ? INFINITY : -INFINITY);
    state.origin = nullptr;
    return state;
}

bool waits(const State& state) {
    return !state.launches.empty();
}

/// The ends of the balls that the reference claims, and that its runs in double precision know too.
void note_ends(Window& window, const Reference& reference) {
    const World& exact = *reference.exact;
    std::set<BallNumber> hit;
    for (const Event& impact : window.impacts) {
        hit.insert(impact.ball);
        if (impact.other.is_ball) hit.insert(impact.other.index);
    }
    const auto balls = exact.balls(), rounded = reference.in_double->balls(),
               again = reference.again->balls();
    const auto uncertainty = exact.uncertainty();
    const auto knows = [](const Ball& there, const Ball& ball) {
        return length(there.position - ball.position) <= horizon_radii * ball.radius;
    };
    for (std::size_t i = 0; i < balls.size() && i < uncertainty.size(); ++i) {
        const Ball& ball = balls[i];
        if (!(uncertainty[i] <= claim_radii * ball.radius)) continue;
        if (!knows(rounded[i], ball) || !knows(again[i], ball)) continue;
        window.ends.push_back(
            {ball.number, ball.position, ball.radius, uncertainty[i], hit.contains(ball.number)});
    }
}

/// Runs the reference over the window that starts from `start`.
Found look(const State& start, double seconds, const Reference& reference) {
    Found found{{start, seconds, {}, {}}, ""};
    const auto hits = [](const World& world) {
        return std::ranges::any_of(world.events(),
                                   [](const Event& event) { return event.kind == EventKind::impact; });
    };
    try {
        for (World* world : reference.all()) {
            world->restore(world == &*reference.again ? with_other_rounding(start) : start);
            world->step(seconds);
            if (hits(*world)) continue;
            found.skipped = "no hit";
            return found;
        }
    } catch (const Refusal&) {
        found.skipped = "refused";
        return found;
    }
    for (const Event& event : reference.exact->events())
        if (event.kind == EventKind::impact) found.window.impacts.push_back(event);
    const auto loses = [&](const World* world) { return world->balls().size() != start.balls.size(); };
    if (std::ranges::any_of(reference.all(), loses)) {
        found.skipped = "a ball is lost";
        return found;
    }
    note_ends(found.window, reference);
    const bool known = std::ranges::any_of(found.window.ends, &Window::End::hit);
    if (!known) found.skipped = "past the horizon";
    return found;
}

/// Moments at which windows of one trajectory start, in order of time.
std::vector<double> moments(const Variant& variant, Dice& dice) {
    std::vector<double> times(states_each);
    for (double& time : times) time = dice.between(variant.from, variant.until);
    std::ranges::sort(times);
    return times;
}

double window_length(const Variant& variant, Dice& dice) {
    const int range = variant.longest - variant.shortest + 1;
    return window_unit * (variant.shortest + static_cast<int>(dice.below(range)));
}

/// Steps to `time` by the script, at 60 steps a second.
void go_on(Session& session, double time, const Script& script, std::size_t& next) {
    while (session.world().time() < time) {
        const double left = time - session.world().time();
        session.step(left < 1.5 * default_step ? left : default_step, script, next);
    }
}

/// A ball in mid-play, from a launch of its own, or nothing where it was lost by then.
std::optional<State> one_in_play(const Variant& variant, const std::shared_ptr<const Scene>& scene,
                                 const Truth& truth, Dice& dice) {
    constexpr double soonest = 1, latest = 6;  // s after the start; the launch is at 0.1 s
    const Script script = trajectory_script(variant, *scene, dice);
    const double time = dice.between(soonest, latest);
    Session session(scene, *truth.engine, truth.trajectory);
    std::size_t next = 0;
    try {
        go_on(session, time, script, next);
    } catch (const Refusal&) {
        return std::nullopt;
    }
    State state = session.world().save();
    if (waits(state) || state.balls.size() != 1) return std::nullopt;
    return state;
}

/// Whether a ball lies in a part or another ball of this state, deeper than rounding.
bool overlaps(const State& state, World& world) {
    constexpr double rounding = 1e-12;  // m
    world.restore(state);
    return std::ranges::any_of(world.contacts(),
                               [](const Contact& contact) { return contact.separation < -rounding; });
}

/// As many balls in mid-play as the variant has, each as it was some time after a launch of its own, on the
/// table of the first.
State crowd(const Variant& variant, const std::shared_ptr<const Scene>& scene, const Truth& truth,
            Dice& dice) {
    constexpr int most_tries = 1000;
    const auto world = truth.engine->make(scene, truth.trajectory);
    State all;
    for (int i = 0; i < most_tries && all.balls.size() < static_cast<std::size_t>(variant.balls); ++i) {
        const auto one = one_in_play(variant, scene, truth, dice);
        if (!one) continue;
        State more = all.balls.empty() ? *one : all;
        more.next_number = static_cast<BallNumber>(all.balls.size() + 1);
        if (!all.balls.empty()) more.balls.push_back(one->balls.front());
        more.balls.back().number = more.next_number - 1;
        if (!overlaps(more, *world)) all = std::move(more);
    }
    all.clock = {};
    return all;
}

/// Adds the windows of one trajectory until the block is full.
void follow(const BlockPlan& plan, const std::shared_ptr<const Scene>& scene, const Truth& truth, Dice& dice,
            const Reference& reference, Block& block, const std::function<void()>& watch) {
    Script script = trajectory_script(plan.variant, *scene, dice);
    const std::vector<double> times = moments(plan.variant, dice);
    Session session(scene, *truth.engine, truth.trajectory);
    if (plan.variant.balls > 1 && is_fired(plan.variant, *scene)) {
        session.restore(crowd(plan.variant, scene, truth, dice));
        std::erase_if(script, [](const TimedControl& timed) {
            return std::holds_alternative<control::Launch>(timed.control);
        });
    }
    std::size_t next = 0;
    for (const double time : times) {
        const double seconds = window_length(plan.variant, dice);
        if (block.windows.size() == plan.size) return;
        watch();
        try {
            go_on(session, time, script, next);
        } catch (const Refusal&) {
            ++block.skipped["trajectory refused"];
            return;
        }
        const State state = session.world().save();
        const auto wanted = static_cast<std::size_t>(plan.variant.balls);
        // Those that were put on the table together do not become more again.
        if (wanted > 1 && state.balls.size() < wanted && is_fired(plan.variant, *scene)) return;
        if (waits(state) || (wanted > 0 && state.balls.size() != wanted)) {
            ++block.skipped["another number of balls"];
            continue;
        }
        Found found = look(state, seconds, reference);
        if (found.skipped.empty())
            block.windows.push_back(std::move(found.window));
        else
            ++block.skipped[found.skipped];
    }
}

/// A seed for each block of each variant.
std::uint64_t seed_of(const BlockPlan& plan) {
    return fnv1a(plan.variant.name + '/' + std::to_string(plan.index) + '/' + std::to_string(plan.seed));
}

}  // namespace

Block make_block(const BlockPlan& plan, const std::shared_ptr<const Scene>& scene, const Truth& truth,
                 const std::function<void()>& watch) {
    Dice dice(seed_of(plan));
    Block block;
    const Reference reference{truth.engine->make(scene, truth.window),
                              truth.engine->make(scene, truth.trajectory),
                              truth.engine->make(scene, truth.trajectory)};
    while (block.windows.size() < plan.size && block.trajectories < most_trajectories) {
        ++block.trajectories;
        follow(plan, scene, truth, dice, reference, block, watch);
    }
    return block;
}

}  // namespace flipside::lab::sweep

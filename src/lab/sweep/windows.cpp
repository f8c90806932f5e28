#include "lab/sweep/windows.hpp"

#include <algorithm>
#include <set>

#include "lab/session.hpp"
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

bool waits(const State& state) {
    return !state.launches.empty();
}

void note_ends(Window& window, const World& world) {
    std::set<BallNumber> hit;
    for (const Event& impact : window.impacts) {
        hit.insert(impact.ball);
        if (impact.other.is_ball) hit.insert(impact.other.index);
    }
    const auto balls = world.balls();
    const auto uncertainty = world.uncertainty();
    for (std::size_t i = 0; i < balls.size() && i < uncertainty.size(); ++i) {
        const Ball& ball = balls[i];
        if (!(uncertainty[i] <= claim_radii * ball.radius)) continue;
        window.ends.push_back(
            {ball.number, ball.position, ball.radius, uncertainty[i], hit.contains(ball.number)});
    }
}

/// Runs the reference over the window that starts from `start`.
Found look(const State& start, double seconds, World& world) {
    Found found{{start, seconds, {}, {}}, ""};
    try {
        world.restore(start);
        world.step(seconds);
    } catch (const Refusal&) {
        found.skipped = "refused";
        return found;
    }
    for (const Event& event : world.events())
        if (event.kind == EventKind::impact) found.window.impacts.push_back(event);
    if (world.balls().size() != start.balls.size()) {
        found.skipped = "a ball is lost";
        return found;
    }
    note_ends(found.window, world);
    const bool known = std::ranges::any_of(found.window.ends, &Window::End::hit);
    if (!known) found.skipped = found.window.impacts.empty() ? "no hit" : "not claimed";
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

/// Adds the windows of one trajectory until the block is full.
void follow(const BlockPlan& plan, const std::shared_ptr<const Scene>& scene, const Truth& truth, Dice& dice,
            World& exact, Block& block, const std::function<void()>& watch) {
    const Script script = trajectory_script(plan.variant, *scene, dice);
    const std::vector<double> times = moments(plan.variant, dice);
    Session session(scene, *truth.engine, truth.trajectory);
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
        if (waits(state) || (wanted > 0 && state.balls.size() != wanted)) {
            ++block.skipped["another number of balls"];
            continue;
        }
        Found found = look(state, seconds, exact);
        if (found.skipped.empty())
            block.windows.push_back(std::move(found.window));
        else
            ++block.skipped[found.skipped];
    }
}

/// A seed for each block of each variant (FNV-1a over what names it).
std::uint64_t seed_of(const BlockPlan& plan) {
    std::uint64_t hash = 14695981039346656037U;
    const std::string text =
        plan.variant.name + '/' + std::to_string(plan.index) + '/' + std::to_string(plan.seed);
    for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211U;
    return hash;
}

}  // namespace

Block make_block(const BlockPlan& plan, const std::shared_ptr<const Scene>& scene, const Truth& truth,
                 const std::function<void()>& watch) {
    Dice dice(seed_of(plan));
    Block block;
    const auto exact = truth.engine->make(scene, truth.window);
    while (block.windows.size() < plan.size && block.trajectories < most_trajectories) {
        ++block.trajectories;
        follow(plan, scene, truth, dice, *exact, block, watch);
    }
    return block;
}

}  // namespace flipside::lab::sweep

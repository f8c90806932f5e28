// The bespoke engine against Box2D in one process, step by step in turn, so that what else the machine
// does meets both alike. Times are CPU time of World::step per ball and step; beside them what the speed
// was bought with: overlap of what touches, balls lost, and energy where it must stay the same.
//
//   flipside_bench [--benchmark_filter=rain/1000]
//
// Counters: ours, box2d (ns per ball and step), ratio (box2d / ours); overlap_*: median over the contacts
// at the end of steps, in radii; lost_*: balls; drift_*: relative change of energy (gas alone). Of rain also
// where ours spends its time, in parts of the sum (search, flight, contact, report) and what a bare loop
// in single precision needs for the same balls (floor, lost_floor: bare_loop.hpp).
// growth: ours per ball-step with that many balls against 1,000, over the same first half second.
// Box2D runs with continuous collision between balls (its defaults: best error) and in rain also without
// (its best speed there).

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include <benchmark/benchmark.h>

#include "bare_loop.hpp"
#include "lab/assets.hpp"
#include "lab/cpu_clock.hpp"
#include "lab/elastic_scenes.hpp"
#include "lab/engines.hpp"
#include "lab/session.hpp"
#include "world/scene_file.hpp"

namespace {

using namespace flipside;

std::shared_ptr<const Scene> shared(Scene scene) {
    return std::make_shared<const Scene>(std::move(scene));
}

lab::Session session(const std::shared_ptr<const Scene>& scene, std::string_view engine,
                     const std::vector<std::string>& changes = {}) {
    const Engine& used = lab::engine_named(engine);
    const Engine* const one[] = {&used};
    return {scene, used, lab::settings_for(used, *scene, lab::parse_changes(changes, one))};
}

/// One engine's run and what is noted of it.
struct Runner {
    lab::Session session;
    double first_energy;
    std::vector<double> overlaps;  ///< radii, of contacts at the end of steps
    std::uint64_t ball_steps = 0;
    std::array<double, 4> stages{};  ///< s

    explicit Runner(lab::Session made)
        : session(std::move(made)), first_energy(lab::energy(session.world(), session.scene())) {}

    void step(double dt) {
        session.step(dt);
        const World& world = session.world();
        for (std::size_t i = 0; i < stages.size(); ++i) stages[i] += world.statistics().stages[i].seconds;
        ball_steps += world.balls().size();
        const double radius = world.balls().empty() ? 1 : world.balls().front().radius;
        for (const Contact& contact : world.contacts())
            overlaps.push_back(std::max(0.0, -contact.separation / radius));
    }
    [[nodiscard]] double nanoseconds() const {
        return 1e9 * session.totals().step_seconds /
               static_cast<double>(std::max<std::uint64_t>(1, ball_steps));
    }
    [[nodiscard]] double median_overlap() {
        if (overlaps.empty()) return 0;
        const auto middle = overlaps.begin() + static_cast<std::ptrdiff_t>(overlaps.size() / 2);
        std::ranges::nth_element(overlaps, middle);
        return *middle;
    }
    [[nodiscard]] double drift() const {
        return (lab::energy(session.world(), session.scene()) - first_energy) / first_energy;
    }
};

void race(benchmark::State& state, Runner& ours, Runner& theirs, double seconds, bool keeps_energy) {
    constexpr double dt = 1.0 / 60;
    const int slice = getenv("SLICE") ? atoi(getenv("SLICE")) : 1;
    const auto steps = static_cast<int>(std::lround(seconds / dt));
    for (auto _ : state)
        for (int done = 0; done < steps; done += slice)
            for (Runner* runner : {&ours, &theirs})
                for (int i = done; i < std::min(steps, done + slice); ++i) runner->step(dt);
    auto& counters = state.counters;
    counters["ours"] = ours.nanoseconds();
    counters["box2d"] = theirs.nanoseconds();
    counters["ratio"] = theirs.nanoseconds() / ours.nanoseconds();
    counters["overlap_ours"] = ours.median_overlap();
    counters["overlap_box2d"] = theirs.median_overlap();
    counters["lost_ours"] = static_cast<double>(ours.session.totals().strays);
    counters["lost_box2d"] = static_cast<double>(theirs.session.totals().strays);
    if (!keeps_energy) return;
    counters["drift_ours"] = ours.drift();
    counters["drift_box2d"] = theirs.drift();
}

/// Parts of our time by stage, measured by the wall's clock.
void tell_stages(benchmark::State& state, const std::array<double, 4>& seconds) {
    constexpr const char* names[] = {"search", "flight", "contact", "report"};
    const double sum = std::accumulate(seconds.begin(), seconds.end(), 0.0);
    for (std::size_t i = 0; i < seconds.size(); ++i) state.counters[names[i]] = seconds[i] / sum;
}

void rain(benchmark::State& state, const char* bullets) {
    const auto balls = static_cast<int>(state.range(0));
    const auto scene = shared(load_scene(lab::scene_file("rain"), balls));
    Runner ours(session(scene, "custom")),
        theirs(session(scene, "box2d", {std::string("bullets=") + bullets}));
    // Box2D takes minutes per second of 100,000 balls: there a tenth of a second must do.
    const double seconds = balls > 10'000 ? 0.1 : 2;
    race(state, ours, theirs, seconds, false);
    tell_stages(state, ours.stages);

    BareLoop floor(*scene);
    const double start = lab::cpu_seconds();
    const auto steps = static_cast<int>(std::lround(seconds * 60));
    for (int i = 0; i < steps; ++i) floor.step(1.0F / 60);
    state.counters["floor"] = 1e9 * (lab::cpu_seconds() - start) / steps / balls;
    state.counters["lost_floor"] = static_cast<double>(floor.lost());
}

/// Nanoseconds per ball and step over half a second.
double cost_of_rain(int balls) {
    Runner ours(session(shared(load_scene(lab::scene_file("rain"), balls)), "custom"));
    for (int i = 0; i < 30; ++i) ours.step(1.0 / 60);
    return ours.nanoseconds();
}

void growth(benchmark::State& state) {
    double few = 0, many = 0;
    for (auto _ : state) {
        few = cost_of_rain(1000);
        many = cost_of_rain(static_cast<int>(state.range(0)));
    }
    state.counters["ours_1000"] = few;
    state.counters["ours"] = many;
    state.counters["ratio"] = many / few;
}

/// Balls of 27 mm let go over the middle of the pinball table.
void pinball(benchmark::State& state, const char* solver) {
    Scene scene = load_scene(lab::scene_file("pinball"));
    const int balls = static_cast<int>(state.range(0));
    const Vec2 middle = 0.5 * (scene.bounds.min + scene.bounds.max);
    scene.balls.clear();
    for (int i = 0; i < balls; ++i) {
        Ball ball = scene.launcher->ball;
        ball.number = static_cast<BallNumber>(i);
        ball.position = middle + Vec2{0.031 * (i % 4) - 0.05, 0.1 + 0.031 * (i / 4)};
        ball.velocity = 1.5 * from_angle(1 + i);
        scene.balls.push_back(ball);
    }
    const auto table = shared(std::move(scene));
    Runner ours(session(table, "custom", {std::string("solver=") + solver})), theirs(session(table, "box2d"));
    race(state, ours, theirs, 3, false);
}

/// Elastic gas: a fifth of a walled square is covered with balls, no gravity.
void gas(benchmark::State& state) {
    const auto scene = shared(lab::elastic_gas(static_cast<int>(state.range(0))));
    Runner ours(session(scene, "custom", {"broad_phase=auto"})), theirs(session(scene, "box2d"));
    race(state, ours, theirs, 6, true);
}

BENCHMARK_CAPTURE(rain, bullets, "on")->Arg(1000)->Arg(5000)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(rain, plain, "off")
    ->Arg(1000)
    ->Arg(5000)
    ->Arg(100'000)
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);
BENCHMARK(growth)->Arg(10'000)->Arg(100'000)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(pinball, discrete, "discrete")
    ->Arg(1)
    ->Arg(8)
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(pinball, continuous, "continuous")
    ->Arg(1)
    ->Arg(8)
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);
BENCHMARK(gas)->Arg(500)->Arg(5000)->Iterations(1)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();

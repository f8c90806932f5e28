// The bespoke engine against Box2D in one process, a quarter of a simulated second in turn, so that what
// else the machine does meets both alike. Times are CPU time of World::step per ball and step, the least of
// five runs in every row (of twenty for `pinball`, which takes milliseconds); the clock is read around such a
// quarter, not around a step, which may take less time than the reading. Beside them stands what the speed
// was bought with: overlap of what touches at the end of every quarter, the deepest overlap of any step,
// balls lost, and energy where it must stay the same. A regime is a row of its own: `rain` falls for its
// first two seconds and lies in heaps from about the sixth.
//
//   flipside_bench [--benchmark_filter=rain/1000]
//
// Counters: ours, box2d (ns per ball and step), ratio (box2d / ours); overlap_*: median over the contacts,
// deepest_*: the largest, both in radii; lost_*: balls; drift_*: relative change of energy (gas alone). Of
// rain also where ours spends its time, in parts of the sum (search, flight, contact, report) and what a bare
// loop in single precision needs for the same balls (floor, lost_floor: bare_loop.hpp). growth: ours per
// ball-step with that many balls against 1,000, over the same two seconds and in turn. Box2D runs with
// continuous collision between balls (its defaults: best error) and in rain also without (its best speed
// there).

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>

#include <benchmark/benchmark.h>

#include "bare_loop.hpp"
#include "lab/assets.hpp"
#include "lab/cpu_clock.hpp"
#include "lab/elastic_scenes.hpp"
#include "lab/engines.hpp"
#include "lab/report/facts.hpp"
#include "lab/session.hpp"
#include "world/scene_file.hpp"

namespace {

using namespace flipside;

std::shared_ptr<const Scene> shared(Scene scene) {
    return std::make_shared<const Scene>(std::move(scene));
}

constexpr double dt = 1.0 / 60;  // s
constexpr int slice = 15;        // steps

/// One engine's run and what is noted of it.
class Runner {
  public:
    explicit Runner(const std::shared_ptr<const Scene>& scene, std::string_view engine,
                    const std::vector<std::string>& changes = {})
        : scene_(*scene), world_(made(scene, engine, changes)), first_energy_(lab::energy(*world_, scene_)) {}

    void run(int steps) {
        const lab::CpuStopwatch watch;
        for (int i = 0; i < steps; ++i) {
            ball_steps_ += world_->balls().size();
            world_->step(dt);
            deepest_ = std::max(deepest_, flipside::deepest_overlap(world_->contacts()));
        }
        seconds_ += watch.seconds();
        note();
    }
    /// Steps that count for nothing: the way to the regime that is measured.
    void skip(int steps) {
        for (int i = 0; i < steps; ++i) world_->step(dt);
        first_energy_ = lab::energy(*world_, scene_);
    }
    [[nodiscard]] double nanoseconds() const { return 1e9 * seconds_ / static_cast<double>(ball_steps_); }
    [[nodiscard]] double median_overlap() {
        if (overlaps_.empty()) return 0;
        const auto middle = overlaps_.begin() + static_cast<std::ptrdiff_t>(overlaps_.size() / 2);
        std::ranges::nth_element(overlaps_, middle);
        return *middle;
    }
    /// Of any step, radii of the first ball.
    [[nodiscard]] double deepest_overlap() const { return deepest_ / radius_; }
    [[nodiscard]] double drift() const {
        return (lab::energy(*world_, scene_) - first_energy_) / first_energy_;
    }
    [[nodiscard]] double lost() const {
        return static_cast<double>(scene_.balls.size() - world_->balls().size());
    }
    [[nodiscard]] const std::array<double, 4>& stages() const { return stages_; }

  private:
    static std::unique_ptr<World> made(const std::shared_ptr<const Scene>& scene, std::string_view engine,
                                       const std::vector<std::string>& changes) {
        const Engine& used = lab::engine_named(engine);
        const Engine* const one[] = {&used};
        return used.make(scene, lab::settings_for(used, *scene, lab::parse_changes(changes, one)));
    }
    void note() {
        for (std::size_t i = 0; i < stages_.size(); ++i) stages_[i] += world_->statistics().stages[i].seconds;
        for (const Contact& contact : world_->contacts())
            overlaps_.push_back(std::max(0.0, -contact.separation / radius_));
    }

    const Scene& scene_;
    std::unique_ptr<World> world_;
    double radius_ = scene_.balls.empty() ? 1 : scene_.balls.front().radius;
    double first_energy_;
    double deepest_ = 0;  // m
    double seconds_ = 0;
    std::uint64_t ball_steps_ = 0;
    std::vector<double> overlaps_;
    std::array<double, 4> stages_{};  ///< s, of the last step of every slice
};

constexpr int repeats = 5;

/// Lets both run `repeats` times from the start and notes the least of each, ns per ball and step.
/// `make_ours` and `make_theirs` give a new runner; the last pair is left for what else is to be told of it.
struct Race {
    std::optional<Runner> ours, theirs;
    double least_ours = INFINITY, least_theirs = INFINITY;

    /// The first `skipped` seconds of each run count for nothing.
    Race(auto&& make_ours, auto&& make_theirs, double skipped, double seconds, int runs = repeats) {
        const auto steps = static_cast<int>(std::lround(seconds / dt));
        for (int run = 0; run < runs; ++run) {
            make_ours(ours);
            make_theirs(theirs);
            for (Runner* runner : {&*ours, &*theirs})
                runner->skip(static_cast<int>(std::lround(skipped / dt)));
            for (int done = 0; done < steps; done += slice)
                for (Runner* runner : {&*ours, &*theirs}) runner->run(std::min(slice, steps - done));
            least_ours = std::min(least_ours, ours->nanoseconds());
            least_theirs = std::min(least_theirs, theirs->nanoseconds());
        }
    }
    void tell(benchmark::State& state) {
        auto& counters = state.counters;
        counters["ours"] = least_ours;
        counters["box2d"] = least_theirs;
        counters["ratio"] = least_theirs / least_ours;
        counters["overlap_ours"] = ours->median_overlap();
        counters["overlap_box2d"] = theirs->median_overlap();
        counters["deepest_ours"] = ours->deepest_overlap();
        counters["deepest_box2d"] = theirs->deepest_overlap();
        counters["lost_ours"] = ours->lost();
        counters["lost_box2d"] = theirs->lost();
    }
};

/// Parts of our time by stage, measured by the wall's clock.
void tell_stages(benchmark::State& state, const std::array<double, 4>& seconds) {
    constexpr const char* names[] = {"search", "flight", "contact", "report"};
    const double sum = std::accumulate(seconds.begin(), seconds.end(), 0.0);
    for (std::size_t i = 0; i < seconds.size(); ++i) state.counters[names[i]] = seconds[i] / sum;
}

void rain(benchmark::State& state, const char* bullets) {
    const auto balls = static_cast<int>(state.range(0));
    const auto scene = shared(load_scene(lab::scene_file("rain"), balls));
    // Box2D takes minutes per second of 100,000 balls: there a tenth of a second must do.
    const double seconds = balls > 10'000 ? 0.1 : 2;
    const auto steps = static_cast<int>(std::lround(seconds / dt));
    for (auto _ : state) {
        Race race([&](auto& ours) { ours.emplace(scene, "custom"); },
                  [&](auto& theirs) {
                      theirs.emplace(scene, "box2d", std::vector{std::string("bullets=") + bullets});
                  },
                  0, seconds);
        race.tell(state);
        tell_stages(state, race.ours->stages());
    }

    BareLoop floor(*scene);
    const double start = lab::cpu_seconds();
    for (int i = 0; i < steps; ++i) floor.step(static_cast<float>(dt));
    state.counters["floor"] = 1e9 * (lab::cpu_seconds() - start) / steps / balls;
    state.counters["lost_floor"] = static_cast<double>(floor.lost());
}

/// The scene as it ships, with its 320 balls, from `from` seconds on for 6 s.
void rain_later(benchmark::State& state) {
    const auto scene = shared(load_scene(lab::scene_file("rain")));
    for (auto _ : state) {
        Race race([&](auto& ours) { ours.emplace(scene, "custom"); },
                  [&](auto& theirs) { theirs.emplace(scene, "box2d"); }, static_cast<double>(state.range(0)),
                  6);
        race.tell(state);
    }
}

/// Nanoseconds per ball and step over the first two seconds.
double cost_of(const std::shared_ptr<const Scene>& rain) {
    Runner ours(rain, "custom");
    ours.run(120);
    return ours.nanoseconds();
}

void growth(benchmark::State& state) {
    const auto rain_of = [](int balls) { return shared(load_scene(lab::scene_file("rain"), balls)); };
    const auto few = rain_of(1000), many = rain_of(static_cast<int>(state.range(0)));
    double least_few = INFINITY, least_many = INFINITY;
    for (auto _ : state)
        for (int i = 0; i < repeats; ++i) {
            least_few = std::min(least_few, cost_of(few));
            least_many = std::min(least_many, cost_of(many));
        }
    state.counters["ours_1000"] = least_few;
    state.counters["ours"] = least_many;
    state.counters["ratio"] = least_many / least_few;
}

/// Balls of 27 mm let go over the middle of the pinball table, their velocities turned by `turn` rad.
Scene pinball_scene(int balls, double turn) {
    Scene scene = load_scene(lab::scene_file("pinball"));
    const Vec2 middle = 0.5 * (scene.bounds.min + scene.bounds.max);
    scene.balls.clear();
    for (int i = 0; i < balls; ++i) {
        Ball ball = scene.launcher->ball;
        ball.number = static_cast<BallNumber>(i);
        const int column = i % 4, row = i / 4;
        ball.position = middle + Vec2{0.031 * column - 0.05, 0.1 + 0.031 * row};
        ball.velocity = 1.5 * from_angle(1 + i + turn);
        scene.balls.push_back(ball);
    }
    return scene;
}

/// The mean of ten starts: what a table costs depends on where its balls come to roll.
void pinball(benchmark::State& state, const char* solver) {
    constexpr int starts = 10;
    double ours = 0, theirs = 0;
    for (auto _ : state)
        for (int start = 0; start < starts; ++start) {
            const auto table = shared(pinball_scene(static_cast<int>(state.range(0)), 0.1 * start));
            const Race race(
                [&](auto& runner) {
                    runner.emplace(table, "custom", std::vector{std::string("solver=") + solver});
                },
                [&](auto& runner) { runner.emplace(table, "box2d"); }, 0, 3, 20);
            ours += race.least_ours / starts;
            theirs += race.least_theirs / starts;
        }
    state.counters["ours"] = ours;
    state.counters["box2d"] = theirs;
    state.counters["ratio"] = theirs / ours;
}

/// Elastic gas: a fifth of a walled square is covered with balls, no gravity.
void gas(benchmark::State& state) {
    const auto scene = shared(lab::elastic_gas(static_cast<int>(state.range(0))));
    for (auto _ : state) {
        Race race([&](auto& ours) { ours.emplace(scene, "custom"); },
                  [&](auto& theirs) { theirs.emplace(scene, "box2d"); }, 0, 6);
        race.tell(state);
        state.counters["drift_ours"] = race.ours->drift();
        state.counters["drift_box2d"] = race.theirs->drift();
    }
}

BENCHMARK_CAPTURE(rain, bullets, "on")->Arg(1000)->Arg(5000)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(rain, plain, "off")
    ->Arg(1000)
    ->Arg(5000)
    ->Arg(100'000)
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);
BENCHMARK(rain_later)->Arg(6)->Arg(12)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK(growth)->Arg(10'000)->Arg(100'000)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(pinball, continuous, "continuous")
    ->Arg(1)
    ->Arg(8)
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);
BENCHMARK(gas)->Arg(500)->Arg(5000)->Iterations(1)->Unit(benchmark::kMillisecond);

}  // namespace

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
    for (const auto& [name, value] : lab::report::build_facts()) benchmark::AddCustomContext(name, value);
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
    return 0;
}

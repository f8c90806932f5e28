#include "lab/pairs/pair_tests.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include <nlohmann/json.hpp>

#include "custom/broad_phase/registry.hpp"
#include "lab/contenders/engines.hpp"
#include "lab/process/cpu_clock.hpp"
#include "lab/scenes/dice.hpp"
#include "world/json_file.hpp"

namespace flipside::lab {

namespace {

constexpr double px = 0.001;  // m
constexpr Vec2 play_box{960 * px, 704 * px};
constexpr double radius = 21 * px;
constexpr double speed = 1000 * px;  // m/s
constexpr int toy_levels = 4;
constexpr int growth_searches = 10;
constexpr std::size_t most_for_brute_force = 5000;
constexpr double share_of_growth = 0.3;  ///< of the time that all takes, for the progress

using BroadPhases = std::vector<std::unique_ptr<custom::BroadPhase>>;

/// All there are, without anything still; brute force first. As few levels of the quadtree as give leaves
/// no larger than the toy's, up to the most that it can have.
BroadPhases all_broad_phases(Vec2 size) {
    const double wanted = toy_levels + std::log2(size.x / play_box.x);
    custom::BroadPhaseOptions options{.world = {{}, size}};
    options.quadtree_levels = static_cast<int>(std::clamp(std::ceil(wanted), 1.0, 8.0));
    options.adaptive_depth = 16;
    BroadPhases all;
    for (const custom::BroadPhaseKind& kind : custom::broad_phases) all.push_back(kind.make({}, options));
    return all;
}

std::shared_ptr<const Scene> toy_scene(int balls) {
    auto scene = std::make_shared<Scene>();
    scene->name = "pair tests";
    scene->bounds = {-0.5 * play_box, 1.5 * play_box};
    scene->materials = {{"default", 1, 0, 0}};
    Part walls;
    walls.name = "walls";
    walls.shape = {shape::Polyline{{{}, {play_box.x, 0}, play_box, {0, play_box.y}}, true}};
    scene->parts.push_back(walls);
    Dice dice(static_cast<std::uint64_t>(balls));
    for (int i = 0; i < balls; ++i) {
        const int place = 13 * i % 32;  // of 8 × 4, far apart at first
        const int column = place % 8, row = place / 8;
        Ball ball;
        ball.number = static_cast<BallNumber>(i);
        ball.position = {(column + 0.5) * play_box.x / 8, (row + 0.5) * play_box.y / 4};
        ball.velocity = speed * dice.direction();
        ball.radius = radius;
        ball.mass = 1;
        scene->balls.push_back(ball);
    }
    return scene;
}

custom::Proxy proxy_of(Vec2 position) {
    return {bounds_of(position, radius), 1, ~0U, true};
}

/// Mean tests per search of each broad phase.
std::vector<double> count_tests(int balls, std::uint64_t steps, const std::function<void()>& watch) {
    const Engine& engine = engine_named("custom");
    const auto scene = toy_scene(balls);
    const auto world = engine.make(scene, settings_for(engine, *scene));
    const BroadPhases all = all_broad_phases(play_box);
    std::vector<custom::Proxy> moving;
    std::vector<custom::Pair> pairs;
    for (std::uint64_t step = 0; step < steps; ++step) {
        world->step(default_step);
        moving.clear();
        for (const Ball& ball : world->balls()) moving.push_back(proxy_of(ball.position));
        for (const auto& broad : all) broad->find_pairs(moving, pairs);
        watch();
    }
    std::vector<double> tests;
    for (const auto& broad : all)
        tests.push_back(static_cast<double>(broad->tests()) / static_cast<double>(steps));
    return tests;
}

/// Balls that fly straight and turn round at the border.
class Flock {
  public:
    Flock(std::size_t balls, Vec2 size) : size_(size) {
        Dice dice(balls);
        for (std::size_t i = 0; i < balls; ++i) {
            const double x = dice.below(size.x), y = dice.below(size.y);
            positions_.push_back({x, y});
            velocities_.push_back(speed * dice.direction());
        }
    }
    void fly(std::vector<custom::Proxy>& moving) {
        moving.clear();
        for (std::size_t i = 0; i < positions_.size(); ++i) {
            Vec2 &p = positions_[i], &v = velocities_[i];
            p += default_step * v;
            if (p.x * v.x < 0 || (p.x - size_.x) * v.x > 0) v.x = -v.x;
            if (p.y * v.y < 0 || (p.y - size_.y) * v.y > 0) v.y = -v.y;
            moving.push_back(proxy_of(p));
        }
    }

  private:
    Vec2 size_;
    std::vector<Vec2> positions_, velocities_;
};

PairTests::Growth measure_growth(std::size_t balls, const std::function<void()>& watch) {
    const Vec2 size = std::sqrt(static_cast<double>(balls) / PairTests::most) * play_box;
    const auto count = static_cast<double>(balls);
    PairTests::Growth growth{balls, {}};
    std::vector<custom::Proxy> moving;
    std::vector<custom::Pair> pairs;
    for (const auto& broad : all_broad_phases(size)) {
        const std::string name(broad->facts().name);
        if (name == "brute force" && balls > most_for_brute_force) continue;
        Flock flock(balls, size);
        flock.fly(moving);
        broad->find_pairs(moving, pairs);  // takes the memory that it needs
        const std::uint64_t before = broad->tests();
        double least = std::numeric_limits<double>::infinity();
        for (int search = 0; search < growth_searches; ++search) {
            flock.fly(moving);
            const CpuStopwatch stopwatch;
            broad->find_pairs(moving, pairs);
            least = std::min(least, stopwatch.seconds());
            watch();
        }
        const auto tests = static_cast<double>(broad->tests() - before);
        growth.costs.push_back({name, tests / growth_searches / count, 1e9 * least / count});
    }
    return growth;
}

}  // namespace

LinearFit fit_line(const std::vector<double>& x, const std::vector<double>& y) {
    const auto n = static_cast<double>(x.size());
    double mean_x = 0, mean_y = 0, xx = 0, xy = 0, yy = 0;
    for (std::size_t i = 0; i < x.size(); ++i) mean_x += x[i] / n, mean_y += y[i] / n;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double dx = x[i] - mean_x, dy = y[i] - mean_y;
        xx += dx * dx, xy += dx * dy, yy += dy * dy;
    }
    const double slope = xy / xx;
    return {slope, mean_y - slope * mean_x, yy > 0 ? xy * xy / (xx * yy) : 1};
}

std::optional<double> crossing_with_brute_force(int first, const std::vector<double>& tests) {
    const auto excess = [&](std::size_t i) {
        const double n = first + static_cast<double>(i);
        return tests[i] - n * (n - 1) / 2;
    };
    if (tests.empty() || excess(tests.size() - 1) >= 0) return std::nullopt;
    std::size_t i = tests.size() - 1;  // the first of those below
    while (i > 0 && excess(i - 1) < 0) --i;
    if (i == 0) return first;
    return first + static_cast<double>(i) - excess(i) / (excess(i) - excess(i - 1));
}

PairTests count_pair_tests(double seconds, std::size_t most_balls, const std::function<void(double)>& watch) {
    const auto steps = static_cast<std::uint64_t>(std::max(1.0, std::round(seconds / default_step)));
    PairTests found{seconds, {}, {}};
    for (const auto& broad : all_broad_phases(play_box))
        found.rows.push_back({std::string(broad->facts().name), {}, {}, {}});

    double done = 0;
    const auto advance_by = [&](double part) {
        return [&done, &watch, part] {
            done += part;
            if (watch) watch(std::min(done, 1.0));
        };
    };
    constexpr int runs = PairTests::most - PairTests::fewest + 1;
    std::vector<double> balls;
    for (int n = PairTests::fewest; n <= PairTests::most; ++n) {
        balls.push_back(n);
        const auto tests =
            count_tests(n, steps, advance_by((1 - share_of_growth) / runs / static_cast<double>(steps)));
        for (std::size_t i = 0; i < tests.size(); ++i) found.rows[i].tests.push_back(tests[i]);
    }
    for (PairTests::Row& row : found.rows) {
        row.line = fit_line(balls, row.tests);
        row.crossing = crossing_with_brute_force(PairTests::fewest, row.tests);
    }
    for (const std::size_t n : {32U, 100U, 320U, 1000U, 3200U, 10'000U, 32'000U, 100'000U})
        if (n <= most_balls)
            found.growth.push_back(measure_growth(
                n, advance_by(share_of_growth * static_cast<double>(n) / 150'000 / 4 / growth_searches)));
    return found;
}

std::string to_json(const PairTests& found) {
    using Json = nlohmann::ordered_json;
    Json toy = Json::array(), growth = Json::array();
    for (const PairTests::Row& row : found.rows) {
        toy.push_back({{"broad_phase", row.broad_phase},
                       {"tests", row.tests},
                       {"slope", row.line.slope},
                       {"intercept", row.line.intercept},
                       {"r_squared", row.line.r_squared},
                       {"crossing", row.crossing ? Json(*row.crossing) : Json(nullptr)}});
    }
    for (const PairTests::Growth& g : found.growth) {
        Json costs = Json::array();
        for (const auto& cost : g.costs)
            costs.push_back({{"broad_phase", cost.broad_phase},
                             {"tests_per_ball", cost.tests_per_ball},
                             {"ns_per_ball", cost.ns_per_ball}});
        growth.push_back({{"balls", g.balls}, {"costs", costs}});
    }
    const Json json{{"seconds", found.seconds},
                    {"balls", {{"from", PairTests::fewest}, {"to", PairTests::most}}},
                    {"toy", toy},
                    {"growth", growth}};
    return json_text(json, 2) + '\n';
}

}  // namespace flipside::lab

#include "lab/regimes/courses.hpp"

#include "lab/files/assets.hpp"
#include "lab/scenes/clear_starts.hpp"
#include "lab/scenes/elastic_scenes.hpp"
#include "world/scene_builder.hpp"
#include "world/scene_file.hpp"

namespace flipside::lab::regimes {

namespace {

std::vector<std::shared_ptr<const Scene>> one(Scene scene) {
    return {std::make_shared<const Scene>(std::move(scene))};
}

Course gas(int balls, double seconds) {
    return {balls, [=] { return one(elastic_gas(balls)); }, {{"gas", 0, seconds, balls <= 500}}, true, true};
}

Course rain(int balls, std::vector<Regime> regimes) {
    return {balls, [=] { return one(load_scene(scene_file("rain"), balls)); }, std::move(regimes)};
}

/// Balls side by side on a floor, in rows that do not touch: all sleep after a second.
Scene balls_at_rest(int balls) {
    Scene scene = empty_scene({0, -9.81});
    constexpr int in_a_row = 100;
    for (int i = 0; i < balls; ++i) {
        const int row = i / in_a_row;
        add_ball(scene, {0.3 * (i % in_a_row), 0.1 + row});
    }
    const double width = 0.3 * in_a_row;
    for (int row = 0; row <= (balls - 1) / in_a_row; ++row)
        add_part(scene, segment({-1, static_cast<double>(row)}, {width, static_cast<double>(row)}));
    const int rows = balls / in_a_row;
    scene.bounds = {{-2, -2}, {width + 1, 2.0 + rows}};
    return scene;
}

/// Balls of 27 mm let go over the middle of the pinball table, their velocities turned by `turn` rad.
Scene pinball_scene(int balls, double turn) {
    Scene scene = load_scene(scene_file("pinball"));
    const Vec2 middle = 0.5 * (scene.bounds.min + scene.bounds.max);
    scene.balls.clear();
    for (int i = 0; i < balls; ++i) {
        Ball ball = scene.launcher->ball;
        ball.number = static_cast<BallNumber>(i);
        const int row = i / 4;
        ball.position = middle + Vec2{0.031 * (i % 4) - 0.05, 0.1 + 0.031 * row};
        ball.velocity = 1.5 * from_angle(1 + i + turn);
        scene.balls.push_back(ball);
    }
    return scene;
}

/// Balls all over the table of the classic toy, each on a free place of a grid, as fast as its launcher
/// makes them at most.
Scene toy_scene(int balls, double turn) {
    Scene scene = load_scene(scene_file("toy"));
    const Launcher launcher = *scene.launcher;
    const double width = 4 * launcher.ball.radius;
    const Box inner{scene.bounds.min + Vec2{width / 2, width / 2}, scene.bounds.max};
    scene.balls.clear();
    for (double y = inner.min.y; y < inner.max.y; y += width)
        for (double x = inner.min.x; x < inner.max.x; x += width) {
            scene.balls.push_back(launcher.ball);
            scene.balls.back().position = {x, y};
            scene.balls.back().number = static_cast<BallNumber>(scene.balls.size() - 1);
        }
    clear_starts(scene);
    const std::vector<Ball> free = std::move(scene.balls);
    scene.balls.clear();
    for (int i = 0; i < balls; ++i) {
        scene.balls.push_back(
            free[static_cast<std::size_t>(i) * free.size() / static_cast<std::size_t>(balls)]);
        scene.balls.back().number = static_cast<BallNumber>(i);
        scene.balls.back().velocity = launcher.fastest * from_angle(1 + i + turn);
    }
    return scene;
}

/// The mean of ten starts: what a table costs depends on where its balls come to roll.
Course table(const char* name, int balls, Scene (*scene)(int balls, double turn)) {
    const auto starts = [=] {
        std::vector<std::shared_ptr<const Scene>> all;
        for (int start = 0; start < 10; ++start)
            all.push_back(std::make_shared<const Scene>(scene(balls, 0.1 * start)));
        return all;
    };
    return {balls, starts, {{name, 0.5, 3}}, false};
}

/// What rain does in its course.
std::vector<Regime> of_rain(int balls) {
    std::vector<Regime> all{{"rain, falling", 0, 1}, {"rain, raining", 1, 5, balls <= 320}};
    if (balls <= 1000) all.push_back({"rain, heaped", 6, 6, true});
    if (balls <= 320) all.push_back({"rain, coming to rest", 10, 10});
    return all;
}

}  // namespace

std::vector<Course> courses() {
    std::vector<Course> all{gas(500, 2), gas(3200, 2), gas(5000, 2)};
    for (const int balls : {320, 1000, 3200, 5000}) {
        all.push_back(rain(balls, of_rain(balls)));
        all.push_back({balls, [=] { return one(balls_at_rest(balls)); }, {{"asleep", 2, 2}}});
    }
    for (const int balls : {1, 8}) all.push_back(table("pinball", balls, pinball_scene));
    for (const int balls : {1, 100}) all.push_back(table("toy", balls, toy_scene));
    return all;
}

std::vector<Course> growth() {
    std::vector<Course> all;
    for (const int balls : {1000, 10'000, 100'000}) all.push_back(gas(balls, 0.5));
    for (const int balls : {1000, 10'000, 100'000}) all.push_back(rain(balls, {{"rain, falling", 0, 1}}));
    return all;
}

}  // namespace flipside::lab::regimes

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

/// Balls of 27 mm over the middle of the pinball table.
Scene balls_on_pinball(int balls) {
    Scene scene = load_scene(scene_file("pinball"));
    const Vec2 middle = 0.5 * (scene.bounds.min + scene.bounds.max);
    scene.balls.clear();
    for (int i = 0; i < balls; ++i) {
        scene.balls.push_back(scene.launcher->ball);
        const int row = i / 4;
        scene.balls.back().position = middle + Vec2{0.031 * (i % 4) - 0.05, 0.1 + 0.031 * row};
    }
    return scene;
}

/// Balls all over the table of the classic toy, each on a free place of a grid.
Scene balls_on_toy(int balls) {
    Scene scene = load_scene(scene_file("toy"));
    const double width = 4 * scene.launcher->ball.radius;
    scene.balls.clear();
    for (double y = scene.bounds.min.y + width / 2; y < scene.bounds.max.y; y += width)
        for (double x = scene.bounds.min.x + width / 2; x < scene.bounds.max.x; x += width) {
            scene.balls.push_back(scene.launcher->ball);
            scene.balls.back().position = {x, y};
            scene.balls.back().number = static_cast<BallNumber>(scene.balls.size() - 1);
        }
    clear_starts(scene);
    const std::vector<Ball> free = std::move(scene.balls);
    scene.balls.clear();
    for (std::size_t i = 0, n = static_cast<std::size_t>(balls); i < n; ++i)
        scene.balls.push_back(free[i * free.size() / n]);
    return scene;
}

/// The mean of ten starts, each ball at this speed, m/s, in a direction of its own: what a table costs
/// depends on where its balls come to roll.
Course table(const char* name, int balls, double speed, Scene (*placed)(int balls)) {
    const auto starts = [=] {
        Scene scene = placed(balls);
        std::vector<std::shared_ptr<const Scene>> all;
        for (int start = 0; start < 10; ++start) {
            for (std::size_t i = 0; i < scene.balls.size(); ++i) {
                scene.balls[i].number = static_cast<BallNumber>(i);
                scene.balls[i].velocity = speed * from_angle(1 + static_cast<double>(i) + 0.1 * start);
            }
            all.push_back(std::make_shared<const Scene>(scene));
        }
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
    for (const int balls : {1, 8}) all.push_back(table("pinball", balls, 1.5, balls_on_pinball));
    for (const int balls : {1, 100}) all.push_back(table("toy", balls, 1, balls_on_toy));
    return all;
}

std::vector<Course> heaps() {
    return {rain(3200, {{"rain, settling", 6, 12}, {"rain, heaped", 18, 6}})};
}

std::vector<Course> growth() {
    std::vector<Course> all;
    for (const int balls : {1000, 10'000, 100'000}) all.push_back(gas(balls, 0.5));
    for (const int balls : {1000, 10'000, 100'000}) all.push_back(rain(balls, {{"rain, falling", 0, 1}}));
    return all;
}

}  // namespace flipside::lab::regimes

// The continuous solver against the reference on random scenes: all shapes, motions and materials, one to six
// balls, at three steps each. Nothing may be further off than 1e-9 radii that is not explained: the reference
// claims no more there, a shift of the start by 1e-13 m leads as far apart, or balls press on each other, so
// that they were in an island, which is inexact by design. The explained are counted and printed.

#include <cstdio>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "in_small.hpp"
#include "lab/engines.hpp"
#include "world/refusal.hpp"
#include "world/scene_builder.hpp"

namespace flipside {
namespace {

constexpr double exact = 1e-9;    // radii
constexpr double shift = 1e-13;   // m
constexpr double duration = 0.6;  // s

class RandomScene {
  public:
    explicit RandomScene(unsigned seed) : random_(seed) {}

    Scene make() {
        Scene scene = empty_scene(pick({Vec2{}, Vec2{0, -9.81}, 4 * direction()}));
        scene.bounds = {{-1.2, -1.2}, {1.2, 1.2}};
        scene.damping = pick({0.0, 0.0, 0.3});
        scene.rest_speed = pick({0.01, 0.1});
        scene.materials[0] = material();
        add_part(scene, {shape::Polyline{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}, true}}, material());
        const int parts = whole(1, 5), balls = whole(1, 6);
        for (int i = 0; i < parts; ++i) add_random_part(scene);
        for (int i = 0; i < balls; ++i) {
            const double radius = real(0.03, 0.1);
            add_ball(scene, {real(-0.85, 0.85), real(-0.85, 0.85)}, real(0, 4) * direction(), radius,
                     pick({0.1, 1.0, 1.0, 30.0}));
            scene.balls.back().spin = pick({0.0, real(-20, 20)});
        }
        return scene;
    }

  private:
    double real(double low, double high) {
        return low + (high - low) * static_cast<double>(random_() >> 11) * 0x1p-53;
    }
    int whole(int low, int high) {
        return low + static_cast<int>(random_() % static_cast<unsigned>(high - low + 1));
    }
    template <class T>
    T pick(std::initializer_list<T> of) {
        return *(of.begin() + whole(0, static_cast<int>(of.size()) - 1));
    }
    Vec2 direction() { return from_angle(real(0, 2 * std::numbers::pi)); }
    Vec2 place() { return {real(-0.8, 0.8), real(-0.8, 0.8)}; }
    Material material() {
        return {"", pick({0.0, 0.5, 0.9, 1.0}), pick({0.0, 0.0, 0.2, 0.6}), pick({0.0, 0.0, 0.0, 1.5})};
    }

    Shape shape() {
        const Vec2 at = place(), to = at + real(0.1, 0.5) * direction();
        switch (whole(0, 6)) {
            case 0:
                return {shape::Point{at}};
            case 1: {
                const double from = real(-3, 3);
                return {shape::Arc{at, real(0.15, 0.5), from, from + real(0.5, 6)}};
            }
            case 2:
                return {shape::Circle{at, real(0.03, 0.2)}};
            case 3: {
                const Vec2 x = real(0.05, 0.2) * direction(), y = real(0.5, 1.5) * perp(x);
                return {shape::Polygon{{at - x - y, at + x - y, at + 0.7 * x + y, at - x + y}}};
            }
            case 4:
                return {shape::Capsule{at, to, real(0.01, 0.08)}};
            case 5:
                return {shape::Polyline{{at, to, to + real(0.1, 0.4) * direction()}, false}};
            default:
                return segment(at, to);
        }
    }

    void add_random_part(Scene& scene) {
        switch (whole(0, 5)) {
            case 0: {
                const Vec2 pivot = place();
                const double rest = real(-3, 3);
                add_part(scene, {shape::Flipper{pivot, real(0.2, 0.4), 0.05, 0.03, rest}}, material())
                    .motion = motion::Flip{Side::left, rest + real(0.3, 1.2), real(5, 30), real(5, 15)};
                return;
            }
            case 1: {
                const Shape turning = shape();
                add_part(scene, turning, material()).motion = motion::Turn{place(), real(-6, 6), true};
                return;
            }
            default: {
                const Shape still = shape();
                add_part(scene, still, material());
            }
        }
    }

    std::mt19937_64 random_;
};

std::unique_ptr<World> world_of(const Scene& scene, const char* engine,
                                std::initializer_list<std::pair<const char*, const char*>> changes) {
    const Engine& used = lab::engine_named(engine);
    Settings settings(used.settings);
    for (const auto& [name, value] : changes) settings.set(name, value);
    return used.make(std::make_shared<const Scene>(scene), settings);
}

/// Takes away the balls that begin in touch with something.
void clear_starts(Scene& scene) {
    for (;;) {
        const auto world = world_of(scene, "custom", {});
        if (world->contacts().empty()) return;
        const BallNumber touching = world->contacts().front().ball;
        std::erase_if(scene.balls, [&](const Ball& ball) { return ball.number == touching; });
        for (BallNumber i = 0; i < scene.balls.size(); ++i) scene.balls[i].number = i;
    }
}

/// Of the worst ball, radii; infinite where the worlds have other balls.
double distance(const World& a, const World& b) {
    if (a.balls().size() != b.balls().size()) return INFINITY;
    double worst = 0;
    for (std::size_t i = 0; i < a.balls().size(); ++i)
        worst = std::max(worst, length(a.balls()[i].position - b.balls()[i].position) / a.balls()[i].radius);
    return worst;
}

enum class Outcome { exact, refused, unknown, chaotic, island, wrong };

/// Up to the end, or to where the first of them differ by more than is exact.
Outcome compare(const Scene& scene, double dt, double& error) {
    Scene shifted = scene;
    for (Ball& ball : shifted.balls) {
        ball.position += {shift, -0.5 * shift};
        ball.velocity += {-shift, shift};  // in a second
        ball.spin += shift / ball.radius;
    }
    const auto ours = world_of(scene, "custom", {{"sleep", "off"}}),
               near = world_of(shifted, "custom", {{"sleep", "off"}}),
               truth = world_of(scene, "reference", {{"twin", "on"}});
    bool pressed = false;
    for (int step = 0; step < duration / dt; ++step) {
        if (step == static_cast<int>(0.2 / dt))
            for (World* world : {&*ours, &*near, &*truth}) world->apply(control::Flip{Side::left, true});
        try {
            truth->step(dt);
        } catch (const Refusal&) {
            return Outcome::refused;
        }
        ours->step(dt);
        near->step(dt);
        pressed = pressed || ours->statistics().handed_over > 0;
        error = distance(*ours, *truth);
        if (error <= exact) continue;
        if (pressed) return Outcome::island;
        for (std::size_t i = 0; i < truth->balls().size(); ++i)
            if (truth->uncertainty()[i] > 0.1 * exact * truth->balls()[i].radius) return Outcome::unknown;
        return distance(*ours, *near) > 0.1 * error ? Outcome::chaotic : Outcome::wrong;
    }
    return Outcome::exact;
}

/// Beyond the first thousand, these once differed: a wide turning arc was passed through on the reference, a
/// ball was left without its support in a wedge.
constexpr unsigned once_wrong[] = {1558, 1913, 2326};

TEST(RandomScenes, AreAsTheReferenceHasThem) {
    constexpr unsigned scenes = test::in_small ? 30 : 1000;
    std::vector<unsigned> seeds(std::begin(once_wrong), std::end(once_wrong));
    for (unsigned seed = 0; seed < scenes; ++seed) seeds.push_back(seed);
    int counts[6] = {};
    for (const unsigned seed : seeds) {
        Scene scene = RandomScene(seed).make();
        clear_starts(scene);
        for (const double dt : {1.0 / 37, 1.0 / 60, 1.0 / 240}) {
            double error = 0;
            const Outcome outcome = compare(scene, dt, error);
            ++counts[static_cast<int>(outcome)];
            EXPECT_NE(outcome, Outcome::wrong) << "scene " << seed << " at " << dt << " s: " << error << " r";
        }
    }
    std::printf(
        "%zu scenes, three steps each: %d exact, %d until the reference refuses, %d where it claims no "
        "more, %d chaotic, %d with balls in islands, %d wrong\n",
        seeds.size(), counts[0], counts[1], counts[2], counts[3], counts[4], counts[5]);
    EXPECT_GT(counts[0], static_cast<int>(seeds.size()));
}

}  // namespace
}  // namespace flipside

#include "lab/hunt/mutate.hpp"

#include <algorithm>

#include "lab/scenes/clear_starts.hpp"
#include "world/input_error.hpp"
#include "world/scene_file.hpp"
#include "world/scene_json.hpp"

namespace flipside::lab::hunt {

namespace {

constexpr std::size_t most_balls = 6, most_parts = 6;
/// kg: a ratio of 1000, as of the hard cases of heavy on light.
constexpr double lightest = 0.03, heaviest = 30;

/// Small and large steps alike.
double step(RandomScene& random) {
    const double size = random.pick({1e-3, 1e-2, 0.1});
    return size * random.real(-1, 1);
}

struct Move {
    Vec2 by;

    void operator()(shape::Point& s) const { s.at += by; }
    void operator()(shape::Segment& s) const { s.a += by, s.b += by; }
    void operator()(shape::Arc& s) const { s.center += by; }
    void operator()(shape::Circle& s) const { s.center += by; }
    void operator()(shape::Polygon& s) const { each(s.points); }
    void operator()(shape::Capsule& s) const { s.a += by, s.b += by; }
    void operator()(shape::Flipper& s) const { s.pivot += by; }
    void operator()(shape::Polyline& s) const { each(s.points); }
    void operator()(shape::Gate& s) const { s.a += by, s.b += by; }
    void operator()(shape::Compound& s) const {
        for (Shape& one : s.of) std::visit(*this, one.is);
    }
    void each(std::vector<Vec2>& points) const {
        for (Vec2& point : points) point += by;
    }
};

void change_ball(Ball& ball, RandomScene& random) {
    switch (random.whole(0, 4)) {
        case 0:
            ball.position += Vec2{step(random), step(random)};
            break;
        case 1:
            ball.velocity += 10 * Vec2{step(random), step(random)};
            break;
        case 2:
            ball.radius = std::clamp(ball.radius * random.real(0.7, 1.4), 0.01, 0.2);
            break;
        case 3:
            ball.mass *= random.pick({0.1, 0.5, 2.0, 10.0});
            ball.mass = std::clamp(ball.mass, lightest, heaviest);
            break;
        default:
            ball.spin = random.pick({0.0, random.real(-20, 20)});
    }
}

void change_part(Scene& scene, RandomScene& random) {
    if (scene.parts.size() < 2) return random.add_part_to(scene);
    const auto at = static_cast<std::size_t>(random.whole(1, static_cast<int>(scene.parts.size()) - 1));
    Part& part = scene.parts[at];
    const bool flips = std::holds_alternative<motion::Flip>(part.motion);
    if (flips || random.whole(0, 2) > 0)
        std::visit(Move{{step(random), step(random)}}, part.shape.is);
    else
        part.shape = random.shape();
}

void change_material(Scene& scene, RandomScene& random) {
    Material& one = scene.materials[static_cast<std::size_t>(
        random.whole(0, static_cast<int>(scene.materials.size()) - 1))];
    const Material other = random.material();
    one.restitution = other.restitution;
    one.friction = other.friction;
    one.kick = other.kick;
}

void change(Scene& scene, RandomScene& random) {
    const auto any_ball = [&] {
        return static_cast<std::size_t>(random.whole(0, static_cast<int>(scene.balls.size()) - 1));
    };
    switch (random.whole(0, 9)) {
        case 0:
            if (scene.balls.size() < most_balls) random.add_ball_to(scene);
            break;
        case 1:
            if (scene.balls.size() > 1)
                scene.balls.erase(scene.balls.begin() + static_cast<std::ptrdiff_t>(any_ball()));
            break;
        case 2:
            if (scene.parts.size() < most_parts) random.add_part_to(scene);
            break;
        case 3:
            if (scene.parts.size() > 1) scene.parts.pop_back();
            break;
        case 4:
            change_material(scene, random);
            break;
        case 5:
            scene.gravity =
                random.pick({Vec2{}, Vec2{0, -9.81}, scene.gravity + Vec2{step(random), step(random)}});
            scene.damping = random.pick({scene.damping, 0.0});
            break;
        case 6:
            change_part(scene, random);
            break;
        default:
            change_ball(scene.balls[any_ball()], random);
    }
}

/// Materials that nothing has go, but for the first, which is that of balls.
void drop_materials(Scene& scene) {
    std::vector<Material> used;
    const auto keep = [&](std::uint32_t& index) {
        used.push_back(scene.materials[index]);
        index = static_cast<std::uint32_t>(used.size() - 1);
    };
    std::uint32_t first = 0;
    keep(first);
    for (Part& part : scene.parts) keep(part.material);
    for (Ball& ball : scene.balls) {
        if (ball.material == 0) continue;
        keep(ball.material);
    }
    scene.materials = std::move(used);
}

/// Names and numbers of their own, whatever came and went.
void number(Scene& scene) {
    drop_materials(scene);
    for (BallNumber i = 0; i < scene.balls.size(); ++i) scene.balls[i].number = i;
    for (std::size_t i = 0; i < scene.parts.size(); ++i) scene.parts[i].name = "part " + std::to_string(i);
    for (std::size_t i = 0; i < scene.materials.size(); ++i)
        scene.materials[i].name = "material " + std::to_string(i);
}

}  // namespace

Scene neighbour_of(const Scene& scene, RandomScene& random) {
    Scene other = scene;
    for (int changes = random.whole(1, 3); changes > 0; --changes) change(other, random);
    return other;
}

std::optional<Written> written(Scene scene) {
    number(scene);
    scene.name = "found";
    try {
        // Its parts and balls are only sure to be right once it was read.
        scene = parse_scene(to_json(scene), "a scene of the hunt");
        clear_starts(scene);
        if (scene.balls.empty()) return {};
        Written both{to_json(scene), {}};
        both.scene = parse_scene(both.text, "a scene of the hunt");
        return both;
    } catch (const InputError&) {
        return {};
    }
}

}  // namespace flipside::lab::hunt

#include "lab/blame/approach.hpp"

#include "lab/blame/met_kind.hpp"
#include "lab/comparison/impact_error.hpp"

namespace flipside::lab {

Vec2 approach_velocity(const Event& impact, BallNumber number, const State& before, const Scene& scene) {
    const double since = impact.time - before.clock.time;
    const auto velocity = [&](BallNumber of) {
        const Ball* ball = find_ball(before.balls, of);
        return ball != nullptr ? ball->velocity + since * (scene.gravity - scene.damping * ball->velocity)
                               : Vec2{};
    };
    const Vec2 own = velocity(number);
    if (impact.other.is_ball) return own - velocity(impact.ball == number ? impact.other.index : impact.ball);
    return own - (impact.speed + dot(own, impact.normal)) * impact.normal;
}

bool rubs(const Event& impact, const State& before, const Scene& scene) {
    const auto of_ball = [&](BallNumber number) -> const Material& {
        const Ball* ball = find_ball(before.balls, number);
        return scene.materials[ball != nullptr ? ball->material : 0];
    };
    const Material& other = impact.other.is_ball ? of_ball(impact.other.index)
                                                 : scene.materials[scene.parts[impact.other.index].material];
    return mix(of_ball(impact.ball), other).friction > 0;
}

double misread_normal(const Event& impact, const State& after, const Scene& scene) {
    const Ball* ball = find_ball(after.balls, impact.ball);
    if (impact.other.is_ball || ball == nullptr) return 0;
    const Vec2 center = impact.point + ball->radius * impact.normal;
    const PartIndex part = impact.other.index;
    Event surface = impact;
    surface.normal = surface_normal(scene, part, after.parts[part], center, ball->radius);
    return error_of(impact, surface).normal;
}

}  // namespace flipside::lab

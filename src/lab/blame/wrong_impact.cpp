#include "lab/blame/wrong_impact.hpp"

#include <algorithm>
#include <cmath>

#include "lab/comparison/impact_error.hpp"

namespace flipside::lab {

WrongImpact compare_impacts(const ImpactPair& pair) {
    const ImpactError error = error_of(pair.own, pair.exact);
    // From what was met to this ball.
    const double side = pair.exact.ball == pair.exact_ball.number ? 1 : -1;
    const Vec2 n = side * pair.exact.normal, own_n = side * pair.own.normal;
    const double jump = pair.exact.impulse / pair.exact_ball.mass;             // m/s, change of velocity
    const double factor = pair.exact.speed > 0 ? jump / pair.exact.speed : 0;  // 1 + e, for a part
    const auto response = [&](Vec2 normal) { return -factor * dot(pair.approach, normal) * normal; };

    const Vec2 velocity = pair.own_ball.velocity - pair.exact_ball.velocity;
    const Vec2 turned = response(own_n) - response(n), rest = velocity - turned;
    const double along = std::abs(dot(rest, n)), across = std::abs(cross(n, rest));
    const Vec2 displaced =
        pair.own_ball.position - pair.exact_ball.position - (pair.time - pair.exact.time) * velocity;
    // A ball behind the exact one, on the side of what it met, was late.
    const Fault time = dot(displaced, n) <= 0 ? Fault::late : Fault::early;
    const double speed = length(pair.approach);

    const WrongImpact normal = pair.misread >= 0.5 * error.normal
                                   ? WrongImpact{Fault::normal, error.normal}
                                   : WrongImpact{error.late >= 0 ? Fault::late : Fault::early,
                                                 speed > 0 ? error.distance / speed : 0};
    const WrongImpact sideways = pair.rubs
                                     ? WrongImpact{Fault::friction, across}
                                     : WrongImpact{Fault::normal, jump > 0 ? std::atan(across / jump) : 0};
    const double left = pair.end - pair.exact.time;
    struct Part {
        double moves = 0;  ///< m until the end
        WrongImpact wrong;
    };
    const Part parts[] = {{left * length(turned), normal},
                          {left * along, {Fault::impulse, along}},
                          {left * across, sideways},
                          {length(displaced), {time, jump > 0 ? length(displaced) / jump : 0}}};
    const Part& worst = *std::ranges::max_element(parts, {}, &Part::moves);
    return worst.moves > 0 ? worst.wrong : WrongImpact{};
}

}  // namespace flipside::lab

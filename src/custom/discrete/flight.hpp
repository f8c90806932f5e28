#pragma once
/// Free flight of a ball in closed form: v' = g − c·v. No step size enters, so flight has no error but
/// rounding.

#include "world/ball.hpp"

namespace flipside::custom {

/// Flight for one stretch of time t: p + a·v + b·g and e·v + a·g.
struct Flight {
    Vec2 gravity;
    double t, a, b;
    double e = 1;

    Flight(Vec2 g, double damping, double time) : gravity(g), t(time), a(time), b(time * time / 2) {
        if (damping == 0) return;
        const double x = damping * time;
        e = std::exp(-x);
        a = -std::expm1(-x) / damping;
        // (t − a)/c loses all its digits when c·t is small; its series does not.
        b = x > 0.01 ? (time - a) / damping
                     : time * time * (1 - x / 3 * (1 - x / 4 * (1 - x / 5 * (1 - x / 6)))) / 2;
    }

    [[nodiscard]] Vec2 position(const Ball& ball) const {
        return ball.position + a * ball.velocity + b * gravity;
    }
    void advance(Ball& ball) const {
        ball.position = position(ball);
        ball.velocity = e * ball.velocity + a * gravity;
        ball.angle += ball.spin * t;
    }
};

}  // namespace flipside::custom

#pragma once
/// The certificate of a run of the exact engine, for a check that is independent of the engine: every path of
/// every ball with the reason for its start, and the motion of the parts. All numbers are rounded to double;
/// times are in s since the start of the certificate.

#include <map>
#include <optional>
#include <vector>

#include "world/ball.hpp"
#include "world/scene.hpp"

namespace flipside::reference {

/// Why a path begins.
struct Beginning {
    enum class Why { given, goes_on, hits_part, hits_ball };
    Why why = Why::goes_on;        ///< given: from outside (the start, or an Input)
    std::uint32_t other = 0;       ///< index of a primitive of the scene's surface, or the number of a ball
    std::size_t other_leg = 0;     ///< of that ball: which of its legs begins by the same contact
    std::optional<double> within;  ///< s: half the width of the interval that isolates the contact
    Vec2 velocity_before;
    double spin_before = 0;
    Vec2 normal;  ///< unit, to the ball
};

/// A path from `start` to the start of the ball's next path, with t relative to `start`: the solution of
/// v' = acceleration − drag·v, plus Σ displacements[k]·t^(k+2). The spin is `roll`·v where roll is not 0,
/// else spin + Σ spins[k]·t^(k+1).
struct Leg {
    Beginning begins;
    double start = 0;
    Vec2 position, velocity, acceleration, roll;
    double drag = 0, spin = 0;
    std::vector<Vec2> displacements;
    std::vector<double> spins;
    std::optional<std::uint32_t> held;  ///< feature along which it moves
};

struct CertifiedBall {
    Ball ball;
    std::vector<Leg> legs;
    std::optional<double> gone;  ///< when it left the world
};

/// From `since` to the next span of the same part it turns at `rate`.
struct TurningSpan {
    double since = 0, angle = 0, rate = 0;
};

/// A gate lets a ball through, from the time at which it is within a radius until it has left.
struct Passage {
    BallNumber ball = 0;
    PartIndex gate = 0;
    double from = 0;
    std::optional<double> until;
};

/// A change from outside: the velocity of one ball is set (a launch, or a raised target that moves the ball
/// out of itself), or that of all balls changes by this (a nudge).
struct Input {
    double time = 0;
    std::optional<BallNumber> ball;  ///< none: all
    Vec2 velocity;
};

/// A drop target is down (or up again) from then on.
struct TargetChange {
    PartIndex part = 0;
    double time = 0;
    bool down = false;
};

/// A contact force between a resting ball and its support.
struct RestingForce {
    BallNumber ball = 0;
    std::optional<BallNumber> other;  ///< a ball, or else
    std::uint32_t feature = 0;        ///< one of the scene's surface
    double normal = 0, friction = 0;  ///< N, on the ball, along the normal to it and perp of that
};

/// A ball at rest on two parts, or the balls of a heap, with the contact forces that balance their weights.
struct Rest {
    double from = 0;
    std::optional<double> until;
    std::vector<RestingForce> forces;
};

struct Certificate {
    std::map<BallNumber, CertifiedBall> balls;
    std::map<PartIndex, std::vector<TurningSpan>> motions;
    std::vector<Passage> passages;
    std::vector<Rest> rests;
    std::vector<TargetChange> targets;
    std::vector<Input> inputs;
};

}  // namespace flipside::reference

#pragma once
/// What a run of the exact engine was made of, for a check that needs nothing of the engine: every path of
/// every ball and why it began, and how the parts moved. All numbers are rounded to double; times are in s
/// since the certificate began.

#include <map>
#include <optional>
#include <vector>

#include "world/ball.hpp"
#include "world/scene.hpp"

namespace flipside::reference {

/// Why a path begins.
struct Beginning {
    enum class Why { given, goes_on, meets_part, meets_ball };
    Why why = Why::goes_on;        ///< given: from outside (the start, a launch, a nudge)
    std::uint32_t met = 0;         ///< index of a feature of the scene's surface, or the number of a ball
    std::size_t met_leg = 0;       ///< of that ball: which of its legs begins by the same touch
    std::optional<double> within;  ///< s: the touch is isolated by this much on either side
    Vec2 velocity_before;
    double spin_before = 0;
    Vec2 normal;  ///< unit, to the ball
};

/// A path from `start` to the start of the ball's next one, with t counted from `start`: the solution of
/// v' = acceleration − drag·v, and Σ displacements[k]·t^(k+2) more. The spin is `roll`·v where roll is not 0,
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

/// A ball is let through by a gate, from its coming within a radius to its leaving.
struct Passage {
    BallNumber ball = 0;
    PartIndex gate = 0;
    double from = 0;
    std::optional<double> until;
};

/// From outside: one ball's velocity is set (a launch), or that of all is changed by this (a nudge).
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

/// A force between a ball and what it rests on.
struct RestingForce {
    BallNumber ball = 0;
    std::optional<BallNumber> other;  ///< a ball, or else
    std::uint32_t feature = 0;        ///< one of the scene's surface
    double normal = 0, friction = 0;  ///< N, on the ball, along the normal to it and perp of that
};

/// A ball that rests on two parts, or balls of a heap on parts and each other, and the forces that hold them
/// so.
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

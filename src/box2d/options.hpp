#pragma once
/// The values of this engine's settings (described in engine.cpp) for one world.

namespace flipside::box2d {

struct Options {
    int velocity_iterations;
    int position_iterations;
    int substeps;
    bool bullets;
    bool continuous;
    bool warm_starting;
    bool verlet;  ///< gravity acts half before and half after a sub-step on balls that touch nothing
    bool sleep;
    double length_scale;  ///< units per metre, > 0
    double chord_error;   ///< m
};

}  // namespace flipside::box2d

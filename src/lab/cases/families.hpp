#pragma once
/// The experiments behind the cases, one file per family, and what they share.

#include "lab/cases/experiment.hpp"

namespace flipside::lab {

inline constexpr double g = 9.81;      // m/s²
inline constexpr double radius = 0.1;  // m, of a ball where nothing else is said

// bounces.cpp
void zeno_drop(Experiment& experiment);
void elastic_drop(Experiment& experiment);
void v_corner(Experiment& experiment);
void far_away(Experiment& experiment);
void friction_bounce(Experiment& experiment);

// chains.cpp
void galperin(Experiment& experiment);
void channel(Experiment& experiment);
void column(Experiment& experiment);
void cradle(Experiment& experiment);
void head_on(Experiment& experiment);
void stacked_drop(Experiment& experiment);
void opposed_balls(Experiment& experiment);

// billiards.cpp
void box(Experiment& experiment);
void circular_billiard(Experiment& experiment);
void grazing(Experiment& experiment);
void thin_wall(Experiment& experiment);
void deep_overlap(Experiment& experiment);

// resting.cpp
void bowl(Experiment& experiment);
void leaving_a_circle(Experiment& experiment);
void incline(Experiment& experiment);
void collinear_segments(Experiment& experiment);
void pile(Experiment& experiment);

// parts.cpp
void flipper(Experiment& experiment);
void sensor(Experiment& experiment);
void crushed_ball(Experiment& experiment);

// gates.cpp
void gate_end(Experiment& experiment);

// joints.cpp
void smooth_joint(Experiment& experiment);

// pressed.cpp
void wedge(Experiment& experiment);
void heavy_on_light(Experiment& experiment);

// symmetry.cpp
void mirror(Experiment& experiment);
void quarter_turn(Experiment& experiment);
void time_reversal(Experiment& experiment);
void step_independence(Experiment& experiment);

// closed_boxes.cpp
void radius_ratio(Experiment& experiment);
void gaining_walls(Experiment& experiment);

// gas.cpp
void mean_free_path(Experiment& experiment);
void disc_gas(Experiment& experiment);
void impact_statistics(Experiment& experiment);
void equipartition(Experiment& experiment);

// galton.cpp
void galton_board(Experiment& experiment);

}  // namespace flipside::lab

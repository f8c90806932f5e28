#pragma once
/// Starts the paths of balls, in flight or in resting contact with a part, and lists them in their cells.

#include <vector>

#include "custom/continuous/gates.hpp"
#include "custom/continuous/simulation.hpp"

namespace flipside::custom {

class Paths {
  public:
    Paths(Simulation& sim, Gates& gates);

    /// Moves a ball that deeply overlaps a part at the start of the window out of it, by position only. A
    /// gate that lets it through does not push it. Each round corrects the deepest overlap; what four
    /// rounds leave remains for later windows.
    void push_out_of_parts(BallIndex i);
    /// Starts the path of a ball at its position: along a part in resting contact, or in free flight.
    void start_path(BallIndex i, double time);
    /// Starts a path that is a flight, with the position and velocity of the ball at its start.
    void start_flight(BallIndex i, const Flight& flight, double time);
    /// Finds when the ball leaves its cell, and its swept bounds until then; at `time` it is `here`.
    void update_swept_bounds(BallIndex i, double time, const Flight::Motion& here);

  private:
    /// Lists a ball in the cell at its position. Fast balls use wide cells, so that no ball changes its cell
    /// more than a thousand times a second.
    void list_in_cell(BallIndex i, double time);
    [[nodiscard]] bool pushes_through(PartIndex by, const Ball& ball, const Touch& touch);
    void find_supports(BallIndex i, double time);
    void note_tangent_faces(Particle& particle) const;
    void choose_support(BallIndex i, double time);
    void rest_between(BallIndex i, double time);

    Simulation& sim_;
    Gates& gates_;
    std::vector<RestingContact> supports_;  ///< of the ball whose path starts
};

}  // namespace flipside::custom

#pragma once
/// Makes Box2D's contacts obey the scene: which pairs collide, how materials mix, kick, gates and joints; and
/// notes the impacts.

#include <vector>

#include <box2d/b2_world_callbacks.h>

#include "box2d/meeting.hpp"
#include "box2d/step_trace.hpp"
#include "box2d/units.hpp"
#include "world/events.hpp"
#include "world/table.hpp"

namespace flipside::box2d {

/// What one pass of the solver, over all velocity iterations, did to a pair.
struct Impact {
    BallNumber ball = 0;
    Other other;
    Vec2 point;   ///< m, on the surface of `other`
    Vec2 normal;  ///< from other to ball
    double speed = 0;
    double impulse = 0;
};

/// Whether a gate lets a ball through that touches it (gate.hpp): as was decided when they met, or now.
[[nodiscard]] bool passes_gate(const Table& table, PartIndex part, Ball ball, Vec2 center, Vec2 velocity);

class ContactRules : public b2ContactListener, public b2ContactFilter {
  public:
    /// `table` and `balls` must outlive this and stay where they are. A ball's body holds in its user data
    /// where in `balls` it is.
    ContactRules(Table& table, const std::vector<Ball>& balls, const Units& units)
        : table_(table), balls_(balls), units_(units) {}

    /// What the rules see and answer is written there from now on; null: nowhere.
    void write_to(StepTrace* trace) { trace_ = trace; }
    /// To be called before each sub-step of `h` seconds.
    void begin_substep(double h) { substep_ = h; }
    /// The impacts since the last clear(), one per ball and other, in that order.
    [[nodiscard]] const std::vector<Impact>& impacts();
    void clear();

    /// Lets through what touches or meets the gate from now on.
    void open_gate(PartIndex part, const b2Body& gate);

    bool ShouldCollide(b2Fixture* a, b2Fixture* b) override;
    void PreSolve(b2Contact* contact, const b2Manifold* old) override;
    void PostSolve(b2Contact* contact, const b2ContactImpulse* impulse) override;

  private:
    [[nodiscard]] const Ball& ball_of(b2Fixture& fixture) const;
    [[nodiscard]] bool meets_gate(const Meeting& meeting, double approach);

    Table& table_;
    const std::vector<Ball>& balls_;
    const Units& units_;
    double substep_ = 0;
    StepTrace* trace_ = nullptr;
    std::vector<Impact> approaches_;  ///< faster than rest, seen before the solver
    std::vector<Impact> solved_;      ///< impulses, seen after it
    std::vector<Impact> impacts_;
};

}  // namespace flipside::box2d

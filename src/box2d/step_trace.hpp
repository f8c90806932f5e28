#pragma once
/// The trace of one call of Box2D's step: what its listeners see, and how balls and boxes differ between
/// before and after. What cannot be seen that way, it says.

#include <map>
#include <span>
#include <vector>

#include <box2d/b2_world.h>

#include "box2d/meeting.hpp"
#include "box2d/units.hpp"
#include "world/trace.hpp"

namespace flipside::box2d {

class StepTrace {
  public:
    /// Before anything has moved; `bodies` are those of `balls`. Keeps references to the first three.
    StepTrace(Trace& trace, const Scene& scene, const Units& units, std::span<b2Body* const> bodies);

    /// Gravity and drag have acted for h seconds: Box2D's own step follows.
    /// `ahead`: for how many of them on each; others get the rest later.
    void fell(std::span<b2Body* const> bodies, std::span<const Ball> balls, const b2World& world, double h,
              std::span<const double> ahead);
    /// They got the rest.
    void fell_after(std::span<b2Body* const> bodies, std::span<const Ball> balls, double h);
    /// What the listener sees of a contact before it is solved, and how it answers; m and m/s.
    void before_solve(const Meeting& meeting, Vec2 point, Vec2 normal, double separation, double approach,
                      double restitution, double friction);
    /// The contact is left out.
    void passed_over(const Meeting& meeting, const char* reason);
    /// After the solve, N·s.
    void after_solve(const Meeting& meeting, double normal_impulse, double tangential_impulse);
    /// Box2D's step of h seconds is over: writes its stages.
    void finish(std::span<b2Body* const> bodies, std::span<const Ball> balls, const b2World& world, double h);

  private:
    struct Motion {
        b2Vec2 position, velocity;
    };
    using FatBoxes = std::map<const b2Fixture*, b2AABB>;

    void collide();
    void solve_velocities(std::span<b2Body* const> bodies, std::span<const Ball> balls);
    void solve_positions(std::span<b2Body* const> bodies, std::span<const Ball> balls, double h);
    void update_tree(std::span<b2Body* const> bodies, std::span<const Ball> balls, const b2World& world);
    void solve_times_of_impact();
    /// Whether the bodies of a contact stand where the step began: it is no time-of-impact sub-step yet.
    [[nodiscard]] bool at_start(const Meeting& meeting) const;
    [[nodiscard]] TraceItem& add(const Meeting& meeting, const char* kind);
    void add_sweep(TraceItem& item, const Meeting& meeting);
    [[nodiscard]] static FatBoxes fat_boxes(const b2World& world);

    Trace& trace_;
    const Scene& scene_;
    const Units& units_;
    std::vector<Motion> before_;
    std::vector<double> ahead_;
    FatBoxes boxes_;
    std::vector<const b2Contact*> pairs_;
    std::vector<TraceItem> contacts_, impulses_, sub_steps_;
    bool in_sub_steps_ = false;
};

}  // namespace flipside::box2d

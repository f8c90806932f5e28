#pragma once
/// Contact islands: the balls that press on each other. They have no first impact, so they advance by ticks,
/// which lie on a grid of the world's time: one solve finds the velocities of all members until the next tick
/// (contact_solver.hpp), and each member follows a parabola that ends where the solve puts it. A slow contact
/// with a member makes a ball a member; it stays one until it has had no load for some ticks, or until an
/// impact separates it. So an impact travels through a heap as a chain of exact impacts. Members that hardly
/// move creep: they are solved at every fourth tick, and in between they are obstacles to the other members,
/// until one of these pushes them. Statistics count members as handed_over.

#include <utility>
#include <vector>

#include "custom/continuous/gates.hpp"
#include "custom/continuous/next_events.hpp"
#include "custom/continuous/paths.hpp"
#include "custom/continuous/simulation.hpp"
#include "custom/islands/contact_solver.hpp"

namespace flipside::custom {

class Islands {
  public:
    Islands(Simulation& sim, Gates& gates, Paths& paths, Predictions& predictions)
        : sim_(sim), gates_(gates), paths_(paths), predictions_(predictions) {}

    void reserve(std::size_t balls);
    /// Starts a window: finds the members at its start, and solves their contacts.
    void start_window();
    /// Solves the contacts of all members at a tick, and predicts their events.
    void tick(double time);

    /// Counts a hit of two balls. Returns whether it is slow and belongs to an inelastic collapse: in a heap
    /// that comes to rest, impacts follow each other ever faster without end (McNamara and Young 1994,
    /// "Inelastic collapse in two dimensions"). Then it becomes a resting contact.
    [[nodiscard]] bool note_hit(BallIndex i, BallIndex j, double approach, double time) const;
    /// Acceleration with which two touching balls would approach each other without a contact force, m/s².
    [[nodiscard]] double closing_acceleration(BallIndex i, BallIndex j, double time) const;
    /// Handles a ball whose events at one instant, or whose insignificant impacts, have no end. All balls in
    /// contact with it, directly or through others, are solved at once as one impact without restitution.
    void solve_jammed(BallIndex first, double time);
    /// Holds a ball in place until the next tick, which comes after `longest` seconds at most: where
    /// solve_jammed() did not help, or a limit on the work in a window is exceeded.
    void freeze(BallIndex i, double time, double longest);
    /// s: how long a jammed ball may be held. A fast one must not stay for a whole tick, since what drives it
    /// goes on.
    [[nodiscard]] double longest_freeze(BallIndex i, double time) const;
    /// Holds a ball in place until the next tick; then it moves on with this velocity. An impact changes the
    /// velocity alone: a ball that could be pushed away again would have events without end.
    void stay_frozen(BallIndex i, Vec2 velocity, double time);

  private:
    // Members (members.cpp).
    void find_members();
    [[nodiscard]] bool in_resting_contact(BallIndex i, BallIndex j, bool beside_island) const;
    void start_member_path(BallIndex i, const Flight& flight, double time, double until);
    void start_tick_path(BallIndex i, double time, const ContactSolver::Body& body);
    void start_creep_path(BallIndex i, double time, double until, const ContactSolver::Body& body);

    // Ticks (ticks.cpp).
    void solve(double time);
    void start_creep(double time);
    void solve_members(double time, double duration);
    void add_member(BallIndex i, double time);
    void stop_pushed_creep(double time);
    void collect_contacts(double time, double duration);
    [[nodiscard]] bool join_overlapped(double time);
    void add_ball_contact(BallIndex i, BallIndex j, double time, double duration);
    [[nodiscard]] double overlap_with_moving_parts(BallIndex i, double time);
    void add_part_contacts(BallIndex i, double time, double duration);
    void add_contact(ContactSolver::Contact contact, const ForceCache& known, double duration);
    void remember_forces(double time, double duration);
    void store_forces();

    Simulation& sim_;
    Gates& gates_;
    Paths& paths_;
    Predictions& predictions_;
    ContactSolver contact_solver_;
    /// Forces of the last tick in this window, of primitive a or ball a on ball b, by index.
    ForceCache part_forces_, ball_forces_;
    bool any_creeps_ = false;
    double deepest_ = 0;               ///< m, deepest overlap of a member with a ball or a moving part
    std::vector<BallIndex> members_;   ///< balls of the current solve, sorted
    std::vector<BallIndex> creeping_;  ///< since the current tick
    std::vector<BallIndex> rank_;      ///< per ball: index among the bodies of a solve
    std::vector<std::pair<BallIndex, BallIndex>> beside_;  ///< each member with each flying ball near it
};

}  // namespace flipside::custom

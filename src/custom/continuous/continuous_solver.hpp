#pragma once
/// The continuous solver: event-driven molecular dynamics (Alder and Wainwright 1959; Lubachevsky 1991, "How
/// to simulate billiards and similar systems"). Every ball follows its exact path to its next event. Events
/// are handled in order of time, and only the balls involved are predicted again. The only error is rounding;
/// none grows with dt.
///
/// The solver works in windows of a quarter of a second, whose ends lie on a grid of the world's time. All
/// balls start a new path at the start of a window; a step handles the events up to its end and reads the
/// balls off their paths. So the result does not depend on the steps, to the bit. A window begins at the end
/// of the previous one, or when something outside the solver has changed the world. Resting contacts follow
/// from positions and velocities at the start, so a window can be repeated from the state of the world there.
///
/// A ball falls asleep at the end of a window if it was at rest in the last sixtieth of a second (sleep.hpp);
/// a sleeping ball that has lost a support wakes there, and so does one beside a ball that moves. If all
/// balls sleep and no part moves, the world is quiet, and a step costs nothing per ball.
///
/// Cells (neighbours.hpp) find neighbours. A ball that changes its cell queries the cells that are new beside
/// it. Of each ball only the next event is kept (next_events.hpp). If the partner of that event has changed
/// its path meanwhile, the ball is predicted again.
///
/// A slow contact with a part becomes a resting contact (resting_contact.hpp): slow is an approach below
/// rest_speed, or a bounce too short to matter. Balls in resting contact with each other have no first
/// impact. They are members of contact islands. At ticks, which lie on a grid of the world's time, one solve
/// finds the velocities of all members until the next tick (contact_solver.hpp), and each member follows a
/// parabola that ends where the solve puts it. A slow contact with a member makes a ball a member; it stays
/// one until it has had no load for some ticks, or until an impact separates it. So an impact travels through
/// a heap as a chain of exact impacts. Members that hardly move creep: they are solved at every fourth tick,
/// and in between they are obstacles to the other members, until one of these pushes them. Inside islands the
/// result is not exact, but it does not depend on the steps. Statistics count members as handed_over.

#include <memory>

#include "custom/broad_phase/broad_phase.hpp"
#include "custom/continuous/neighbours.hpp"
#include "custom/continuous/next_events.hpp"
#include "custom/continuous/resting_contact.hpp"
#include "custom/islands/contact_solver.hpp"
#include "custom/islands/sleep.hpp"
#include "custom/layout.hpp"
#include "custom/response.hpp"
#include "custom/settings.hpp"
#include "custom/step_record.hpp"

namespace flipside::custom {

class ContinuousSolver {
  public:
    /// Keeps references to all but the settings. `broad` finds the contacts at the start of a window that
    /// does not follow on another.
    ContinuousSolver(Table& table, const Layout& layout, BroadPhase& broad, const SolverSettings& settings);

    /// Reserves memory for so many balls.
    void reserve(std::size_t balls);
    /// Moves clock, parts and balls by dt.
    void step(double dt, std::vector<Ball>& balls, StepRecord& record);
    /// Ends the window here, after something outside the solver has changed balls or parts, or added balls.
    void interrupt() { in_window_ = quiet_ = contacts_known_ = false; }
    /// The same after balls were removed or replaced; clears all that the solver holds of them.
    void begin_anew() { interrupt(), balls_known_ = false; }
    /// Whether nothing moves until interrupt(): all balls sleep and no part moves.
    [[nodiscard]] bool quiet() const { return quiet_; }
    /// Whether a ball fell asleep in the last step.
    [[nodiscard]] bool fell_asleep() const { return fell_asleep_; }

    /// State at the start of the current window, which leads to the present state; null between windows.
    [[nodiscard]] std::shared_ptr<const State> origin() const;
    /// Keeps the current window for kept_origin(), until the next call.
    void keep();
    [[nodiscard]] std::shared_ptr<const State> kept_origin() const;
    /// Runs the window that begins at the state's origin, which is loaded already, up to the state. Returns
    /// false if that does not lead to the state: another engine wrote it, or it was changed.
    bool resume(const State& state, std::vector<Ball>& balls, StepRecord& record);

    /// Pairs whose boxes overlap and which contain an awake ball, in the order of a broad phase; `balls` are
    /// those after the last step.
    [[nodiscard]] std::span<const Pair> find_pairs(std::span<const Ball> balls);
    /// Draws the cells.
    void inspect_cells(Inspector& inspector) const { cells_.inspect(inspector); }

  private:
    enum class EventType : std::uint8_t { none, feature, ball, path_end, sensor, leave_bounds };
    using BallIndex = std::uint32_t;  ///< of a ball in bodies_

    /// s: time step of the island solver.
    static constexpr double tick_length = 1.0 / 240;
    static constexpr double long_tick_length = 4 * tick_length;  ///< time step of creeping members, s
    /// s without a load after which a ball leaves its island: at the third tick.
    static constexpr double longest_unloaded = 2.5 * tick_length;

    /// The data of a ball that predictions of other balls read, in one cache line.
    struct alignas(64) HotState {
        Vec2 position, velocity;  ///< at the start of its path
        double start = 0;         ///< of its path, s
        double radius = 0;
        std::uint32_t version = 0;  ///< incremented whenever its path changes
        std::uint32_t batch = 0;    ///< in which it was predicted last
        bool ballistic = false;     ///< its path is a flight under gravity and drag alone
        bool in_island = false;     ///< in resting contact with another ball, or jammed
        bool lost = false;          ///< has left the bounds
        bool creeps = false;        ///< in an island, and hardly moves until its next long tick
        bool in_solve = false;      ///< is a body of the current solve
    };
    /// When a ball may be within touch_distance of others, on its path and theirs.
    struct NearTimes {
        double until = -INFINITY;  ///< s: so long it may be near a ball that it leaves
        double from = INFINITY;    ///< s: from then on it may be near a ball that it approaches
        bool part = false;         ///< it may be near a part before cell_exit

        [[nodiscard]] bool ball_at(double time) const { return time <= until || time >= from; }
    };
    /// All other data that the solver keeps of a ball beside the Ball itself; first what a read-out needs.
    struct Mover {
        ConstrainedPath motion;     ///< since its last event
        bool on_tick_path = false;  ///< in an island, on the path that the last tick gave it
        BallNumber number = 0;
        bool jammed = false;                ///< since the last regular tick: solve_jammed()
        bool frozen = false;                ///< stays in place without events until the next tick: freeze()
        double last_loaded = 0;             ///< s: when it last had a load from a ball, or from two sides
        int loads = 0;                      ///< contacts that carry a force; those with balls count twice
        Vec2 velocity_begin, velocity_end;  ///< m/s, at the ends of a tick; the parabola between has others
        EventType next = EventType::none;
        double next_time = 0;
        std::uint32_t partner = 0;          ///< FeatureIndex, BallIndex or PartIndex, according to `next`
        std::uint32_t partner_version = 0;  ///< version of the partner's path in this prediction
        double last_event = -1;             ///< s
        double last_slow = -INFINITY;       ///< s, of its last slow contact with a ball
        double last_hit = -INFINITY;        ///< s, of its last contact with a ball
        int hits = 0;                 ///< contacts with balls in a row, each within a tick of the one before
        int simultaneous_events = 0;  ///< at the time last_event
        bool meets_balls = false;     ///< in one of these events
        int idle_events = 0;          ///< since its last significant impact
        double events_until = 0;      ///< s: end of the time that its events take at least_interval each
        double cell_exit = 0;         ///< s: when it must be listed in another cell
        Box bounds;                   ///< swept bounds of its path until cell_exit, with touch_distance
        const Feature* resting_on = nullptr;      ///< its resting contact
        const Feature* separated_from = nullptr;  ///< the resting contact that has just ended
        TangentFaces tangent_faces;               ///< faces along which it flies
    };
    /// Order of events at the same time, whichever ball predicted them: first those without a second ball,
    /// then by the lower ball, then by the higher.
    [[nodiscard]] static std::uint64_t order_of(BallIndex i, EventType next, std::uint32_t partner);

    // Windows, from start to end, and the events of each (continuous_solver.cpp).
    void advance_to(const Clock& now, std::vector<Ball>& balls);
    void begin(const std::vector<Ball>& balls);
    void choose_end();
    void find_sensed(std::span<const Ball> balls);
    void assign_movers();
    void run(double until);
    void start_all_paths();
    void handle_until(double time);
    void read(double time, double now, std::vector<Ball>& balls);
    void end(double now, std::vector<Ball>& balls);
    [[nodiscard]] const State& start() const { return starts_[current_]; }
    [[nodiscard]] Ball ball_at(BallIndex i, double time) const;
    void report_until(double time, double now);
    void pair_with_parts(std::span<const Ball> balls, BallIndex i);
    void pair_with_balls(std::span<const Ball> balls, BallIndex i);

    // Members of islands (islands/members.cpp).
    void find_islands();
    [[nodiscard]] bool in_resting_contact(BallIndex i, BallIndex j, bool beside_island) const;
    [[nodiscard]] double closing_acceleration(BallIndex i, BallIndex j, double time) const;
    void join_island(BallIndex i, double time);
    void leave_island(BallIndex i);
    void solve_jammed(BallIndex first, double time);
    void freeze(BallIndex i, double time);
    void stay_frozen(BallIndex i, Vec2 velocity, double time);
    void start_member_path(BallIndex i, const Flight& flight, double time, double until);
    void start_tick_path(BallIndex i, double time, const ContactSolver::Body& body);
    void start_creep_path(BallIndex i, double time, double until, const ContactSolver::Body& body);
    void advance_to(BallIndex i, double time);
    [[nodiscard]] Vec2 true_velocity(BallIndex i, double time) const;
    [[nodiscard]] static bool creeps_at(double speed, const Ball& ball);
    [[nodiscard]] bool collapses(BallIndex i, BallIndex j, double approach, double time);
    [[nodiscard]] bool in_slow_contact(BallIndex i, BallIndex j, double time) const;
    [[nodiscard]] bool rests_on(BallIndex i, const Feature& feature, const Pose& pose, double time) const;

    // Ticks (islands/ticks.cpp).
    [[nodiscard]] double next_on_grid(double time, double length) const;
    [[nodiscard]] double next_tick(double time) const;
    void tick(double time);
    void solve_islands(double time);
    void start_creep(double time);
    void solve_members(double time, double duration);
    void add_member(BallIndex i, double time);
    void stop_pushed_creep(double time);
    void collect_contacts(double time, double duration);
    void add_ball_contact(BallIndex i, BallIndex j, double time, double duration);
    [[nodiscard]] double overlap_with_moving_parts(BallIndex i, double time);
    void add_part_contacts(BallIndex i, double time, double duration);
    void add_contact(ContactSolver::Contact& contact, const ForceCache& known, double duration);
    void remember_forces(double time, double duration);
    void store_forces();

    // Predictions (next_events.cpp).
    void predict(BallIndex i, double time);
    void predict_together(std::span<const BallIndex> balls, double time);
    void predict_with(BallIndex i, double time, auto&& each_other);
    void predict_features(BallIndex i, double time);
    void predict_sensors(BallIndex i, double time, std::span<const FeatureIndex> near);
    [[nodiscard]] bool slides_to(const Mover& mover, const Ball& ball, const Feature& feature) const;
    [[nodiscard]] static bool above_tangent_face(const Mover& mover, const Feature& feature,
                                                 const Pose& pose);
    void predict_ball(BallIndex i, BallIndex j, double time);
    void predict_flying(BallIndex i, BallIndex j, double time);
    void note_near(BallIndex i, BallIndex j, double until, double from);
    void predict_loss(BallIndex i, double time);
    void enter_cell(BallIndex i);
    void schedule(BallIndex i);
    void offer(BallIndex i, double time, EventType next, std::uint32_t partner = 0,
               std::uint32_t partner_version = 0);
    [[nodiscard]] double sense_time(PartIndex part, const Ball& ball, const Path& path, double time,
                                    double last, bool inside) const;
    [[nodiscard]] bool ignores(const Feature& feature, const Ball& ball) const;

    // Paths and resting contacts with parts (path.cpp).
    struct Support {
        RestingContact contact;
        bool loaded = false;       ///< a force keeps the ball on it
        Vec2 direction{};          ///< unit, in which the ball moves along it
        double distance_left = 0;  ///< m, to the end of the feature in that direction
    };
    void push_out_of_parts(BallIndex i);
    [[nodiscard]] bool pushes_through(PartIndex by, const Ball& ball, const Touch& touch);
    void start_path(BallIndex i, double time);
    void list_in_cell(BallIndex i, double time);
    [[nodiscard]] std::span<const FeatureIndex> features_near(BallIndex i, const Box& box);
    void update_swept_bounds(BallIndex i, double time);
    [[nodiscard]] bool beside_moving_part(BallIndex i);
    void find_directions(const Ball& ball, double time);
    [[nodiscard]] static bool takes_precedence(const Support& support, const Support& other);
    void find_supports(BallIndex i, double time);
    void note_tangent_faces(Mover& mover) const;
    [[nodiscard]] bool supports_alone(const Support& support, const Ball& ball) const;
    void choose_support(BallIndex i, double time);
    void rest_between(BallIndex i, double time);

    // Events (events.cpp).
    [[nodiscard]] bool exceeds_limits(Mover& mover, double time, bool with_ball) const;
    void handle(BallIndex i);
    static void advance(Ball& ball, const ConstrainedPath& motion, double time);
    [[nodiscard]] bool is_significant(const Impact& impact, const Ball& ball) const;
    void hit_feature(BallIndex i, double time);
    void hit_ball(BallIndex i, double time);
    void lose(BallIndex i, double time);
    void sense(BallIndex i, double time);
    void release(PartIndex part, double time);
    void restart(BallIndex i, double time);
    [[nodiscard]] bool inside(BallNumber ball, PartIndex part) const;
    void set_inside(BallNumber ball, PartIndex part, bool inside);
    void report(double time, EventKind kind, const Ball& ball, Other other, const Impact& impact, Vec2 point);
    void wake_carried(BallIndex i, double time);
    void settle_gates();
    void settle_gate(PartIndex part);
    [[nodiscard]] bool lets_through(PartIndex part, const Ball& ball, double time) const;
    [[nodiscard]] bool meet_gate(BallIndex i, PartIndex part, double time);
    void leave_gate(BallNumber ball, PartIndex part, double time);
    [[nodiscard]] double distance_to(PartIndex part, Vec2 center, double radius, const Pose& pose) const;

    // Traces (trace/continuous_trace.cpp).
    [[nodiscard]] std::string_view name_of_next(BallIndex i) const;
    void trace_next(TraceItem& item, BallIndex i) const;
    void trace_paths(bool all_start);
    void trace_event(BallIndex i);
    void trace_tick(double time, double duration);

    Table& table_;
    const Scene& scene_;
    const Layout& layout_;
    BroadPhase& broad_;
    SolverSettings settings_;
    ExternalForces external_;
    double slow_;  ///< m/s: slower approaches inside an island are resting contacts, not impacts
    std::vector<Feature> features_;
    BoxIndex ranges_;                                      ///< of features
    std::vector<std::vector<PrimitiveIndex>> primitives_;  ///< per part, of sensors and gates only
    std::vector<Sensed> inside_;                           ///< balls in sensors and open gates, sorted

    // The current window.
    StepRecord* record_ = nullptr;
    bool in_window_ = false, quiet_ = false;
    double start_ = 0;            ///< s, on the table's clock; all other times are relative to it
    double end_on_clock_ = 0;     ///< the same of the end, s
    double end_ = 0;              ///< of the window, s
    double after_end_ = 0;        ///< the next number after end_
    double read_at_ = 0;          ///< time of the last read(), s
    std::vector<Ball> bodies_;    ///< each at the start of its path
    std::vector<Event> pending_;  ///< not recorded yet
    bool paths_started_ = false;  ///< start_all_paths() has run
    std::uint64_t events_ = 0, search_steps_ = 0;
    double next_tick_ = 0;
    bool any_in_island_ = false, any_creeps_ = false;
    std::uint32_t batch_ = 0;

    // Kept from window to window.
    bool balls_known_ = false;     ///< there is data on the balls from the previous window
    bool contacts_known_ = false;  ///< contacts_ is up to date
    TouchList contacts_;           ///< at the start of the window
    Sleep sleep_;
    double watch_at_ = 0;   ///< s, on the table's clock: when to watch the balls in this window
    bool watched_ = false;  ///< sleep_.watch() has been called in it
    bool fell_asleep_ = false;
    std::array<State, 2> starts_;  ///< of the current window, and of the one that is kept
    std::size_t current_ = 0, kept_ = 0;
    bool kept_in_window_ = false;

    // Buffers, kept to save allocations.
    std::vector<Turning> turnings_;       ///< per part
    std::vector<Mover> pool_;             ///< keeps the memory of their Taylor polynomials
    std::span<Mover> movers_;             ///< the first of the pool, per ball
    std::vector<HotState> hot_;           ///< per ball
    std::vector<NearTimes> near_;         ///< per ball
    std::vector<Candidates> candidates_;  ///< per ball: the features near it
    NextEvents next_events_;
    Cells cells_;
    std::vector<FeatureIndex> found_features_;    ///< buffer of features_near()
    std::vector<FeatureIndex> crossed_features_;  ///< buffer of pushes_through()
    std::vector<Support> supports_;
    ContactSolver contact_solver_;
    /// Forces of the last tick in this window, of primitive a or ball a on ball b, by index.
    ForceCache part_forces_, ball_forces_;
    double deepest_ = 0;                 ///< m, deepest overlap of balls in islands
    std::vector<BallIndex> members_;     ///< balls of the current solve, sorted
    std::vector<BallIndex> creeping_;    ///< since the current tick
    std::vector<BallIndex> woken_;       ///< by the current event
    std::vector<BallIndex> overlapped_;  ///< non-members that members overlap
    std::vector<BallIndex>
        rank_;  ///< index of a ball among those of the last read(), or among the bodies of a solve
    std::vector<Pair> pairs_;
};

}  // namespace flipside::custom

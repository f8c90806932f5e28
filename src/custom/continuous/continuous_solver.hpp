#pragma once
/// The continuous solver: every ball flies its exact path to its next event, events are handled in order of
/// time, and only the balls involved are predicted again (Alder and Wainwright 1959; Lubachevsky 1991, "How
/// to simulate billiards and similar systems"). There is no error but rounding, and none that grows with dt.
///
/// It works in windows of time, of a quarter of a second or less. At the start of a window all balls set out;
/// then it is run to any instants in it, and read there. How often it is read changes no bit. What a ball
/// rests on follows from where it is and how it moves at the start, so a window can be made again from the
/// state of the world there.
///
/// Balls find each other in cells (cells.hpp); a ball that leaves its cell looks at the new ones beside it.
/// Of each ball the next event alone is kept (next_events.hpp); what it is about may have changed its path
/// meanwhile, then the ball is predicted again.
///
/// A slow contact with a part (approach below rest_speed, or a hop too short to matter) holds: see
/// resting_contact.hpp. Balls that press on each other have no first impact. They are members of islands: at
/// ticks, which lie on a grid of the world's time, one solve finds how all members move until the next
/// (contact_solver.hpp), and each then flies a hop that ends where the solve puts it. A slow touch of a
/// member makes a ball a member until nothing has pressed on it for some ticks; a blow tears one out, so it
/// runs through a heap by exact impacts. Members that hardly move creep: they are solved at every fourth
/// tick, and in between are obstacles to the others, unless one of these pushes them. In islands the result
/// is not exact, but it depends on no step either. Statistics count members as handed_over.

#include "custom/continuous/candidates.hpp"
#include "custom/continuous/cells.hpp"
#include "custom/continuous/glides.hpp"
#include "custom/continuous/next_events.hpp"
#include "custom/continuous/resting_contact.hpp"
#include "custom/islands/contact_solver.hpp"
#include "custom/islands/remembered_forces.hpp"
#include "custom/layout.hpp"
#include "custom/response.hpp"
#include "custom/settings.hpp"
#include "custom/step_record.hpp"

namespace flipside::custom {

class ContinuousSolver {
  public:
    /// Keeps references to the table's scene and to layout.
    ContinuousSolver(const Table& table, const Layout& layout, const SolverSettings& settings);

    /// Begins a window of time: the balls set out at the table's time, for `length` seconds. Until the end of
    /// the window the table's clock and parts are the caller's, its gates and targets the solver's.
    void begin(Table& table, std::span<const Ball> balls, double length, StepRecord& record);
    /// Handles the events up to `until`, in seconds since the window's start.
    void run(double until, StepRecord& record);
    /// Where the balls are `time` seconds after the window's start, which run() has reached; lost ones are
    /// left out. Writes the events up to there that were not written yet; none gets a time after `now`.
    void read(double time, double now, std::vector<Ball>& balls);
    /// The same at the end of the window, after a run to there. Another one is to begin.
    void end(double now, std::vector<Ball>& balls);

    /// The state of the world at the window's start.
    [[nodiscard]] const State& start() const { return starts_[current_]; }
    /// The start of the window that is under way now is kept when others begin, until the next call.
    void keep_start() { kept_ = current_; }
    [[nodiscard]] const State& kept_start() const { return starts_[kept_]; }
    /// Whether nothing happens in this window: all balls sleep on, and no part moves.
    [[nodiscard]] bool quiet() const { return !any_awake_; }
    /// Draws the cells.
    void inspect_cells(Inspector& inspector) const { cells_.inspect(inspector); }
    /// Pairs of primitives and awake balls that are near each other, as a broad phase gives them; `balls` as
    /// they were read last.
    [[nodiscard]] std::span<const Pair> find_pairs(std::span<const Ball> balls);
    /// Makes room for so many balls.
    void reserve(std::size_t balls);
    /// Forgets what it noted of sensors and gates: they are found anew from where the balls are.
    void reset(const Table& table, std::span<const Ball> balls);

  private:
    enum class Next : std::uint8_t { nothing, feature, ball, look_again, sense, leave_bounds };
    using BallIndex = std::uint32_t;  ///< of a ball in the list

    /// s: so long the forces between balls that press on each other are held constant.
    static constexpr double tick_length = 1.0 / 240;
    static constexpr double long_tick_length = 4 * tick_length;  ///< for those that creep
    /// s without a load, and a ball leaves its island: at the third tick.
    static constexpr double longest_unloaded = 2.5 * tick_length;

    /// What the prediction of another ball reads of one: a cache line.
    struct alignas(64) Flying {
        Vec2 position, velocity;  ///< at the start of its path
        double start = 0;         ///< s
        double radius = 0;
        std::uint32_t changes = 0;  ///< of its path
        std::uint32_t batch = 0;    ///< in which it was predicted last
        bool freely = false;        ///< under gravity and drag alone
        bool pressed = false;       ///< of an island: presses on another ball, or is wedged
        bool meets = true;          ///< not lost
        bool creeps = false;        ///< of an island, and hardly moves until its next tick, a long one
        bool solved = false;        ///< its contacts are being solved
        bool near_ball = false;     ///< may come nearer to one, on this path, than what counts as touch
    };
    /// What the solver knows of a ball beside the Ball itself.
    struct Mover {
        BallNumber number = 0;
        bool lost = false;
        bool hops = false;       ///< of an island, and set out by a tick
        bool near_part = false;  ///< may be nearer to one than what counts as touch, until its horizon
        bool crushed = false;    ///< squeezed, since the last tick of the grid
        bool waits = false;      ///< has no events of its own until the next tick
        double loaded_at = 0;    ///< s: when a ball pressed on it last, or two sides did
        int sides = 0;           ///< that press on it, those of balls doubly
        Vec2 set_out_with, arrives_with;  ///< m/s, at the ends of a tick; in between its path hops
        Next next = Next::nothing;
        double next_time = 0;
        std::uint32_t met = 0;                ///< FeatureIndex, BallIndex or PartIndex by `next`
        std::uint32_t met_changes = 0;        ///< the other ball's, when this was predicted
        double last_time = -1;                ///< of its last event
        double last_slow = -INFINITY;         ///< of its last slow touch of a ball
        double last_hit = -INFINITY;          ///< of its last touch of a ball
        int hits = 0;                         ///< of balls, none later than a tick after the one before
        int stalled = 0;                      ///< events at that very time
        int idle = 0;                         ///< events since its last impact that counts
        double horizon = 0;                   ///< s: it is listed in its cell until then
        Box bounds;                           ///< of its way until then
        const Feature* resting_on = nullptr;  ///< what it rests on
        const Feature* released = nullptr;    ///< what it just let go
        Glides glides;                        ///< faces that it flies along
        Candidates near;
        ConstrainedPath way;  ///< from its last event on
    };
    /// What happens at the same time is taken in an order that does not depend on who predicted it: first
    /// what meets no ball; then by the first ball, then by the second.
    [[nodiscard]] static std::uint64_t order_of(BallIndex i, Next next, std::uint32_t met);

    // The window as a whole (continuous_window.cpp).
    void take_places();
    void set_out_all();
    void handle_until(double time);
    [[nodiscard]] Ball ball_at(BallIndex i, double time) const;
    void report_until(double time, double now);
    void drop_lost();

    // What happens at its start, and which pairs are near when it is read (continuous_solver.cpp).
    void come_out(BallIndex i);
    void find_islands();
    [[nodiscard]] bool presses(BallIndex i, BallIndex j, bool beside_island) const;
    void pair_with_parts(std::span<const Ball> balls, BallIndex i);
    void pair_with_balls(std::span<const Ball> balls, BallIndex i);
    [[nodiscard]] double closing_acceleration(BallIndex i, BallIndex j, double time) const;

    // Balls in islands (continuous_islands.cpp).
    void join(BallIndex i, double time);
    void leave(BallIndex i);
    void crush(BallIndex first, double time);
    void wait(BallIndex i, double time);
    void set_out_member(BallIndex i, const Flight& flight, double time, double until);
    void hop(BallIndex i, double time, const ContactSolver::Body& body);
    void creep(BallIndex i, double time, double until, const ContactSolver::Body& body);
    void move_to(BallIndex i, double time);
    void follow(Ball& ball, const Mover& mover, double time) const;
    [[nodiscard]] Vec2 true_velocity(BallIndex i, double time) const;
    [[nodiscard]] static bool creeps_at(double speed, const Ball& ball);
    [[nodiscard]] bool rattles(BallIndex i, BallIndex j, double approach, double time);
    [[nodiscard]] bool in_slow_touch(BallIndex i, BallIndex j, double time) const;
    [[nodiscard]] bool rests_on(BallIndex i, const Feature& feature, const Pose& pose, double time) const;

    // Their ticks (continuous_ticks.cpp).
    [[nodiscard]] double next_on_grid(double time, double length) const;
    [[nodiscard]] double next_tick(double time) const;
    void tick(double time);
    void let_creep(double time);
    void solve_members(double time, double duration);
    void take_in(BallIndex i, double time);
    void take_in_pushed(double time);
    void gather(double time, double duration);
    void press_balls(BallIndex i, BallIndex j, double time, double duration);
    void press_parts(BallIndex i, double time, double duration);
    void press(ContactSolver::Contact& contact, const RememberedForces& known, double duration);
    void note_forces(double time, double duration);
    void store_forces();

    // Gates (continuous_gates.cpp).
    void settle_gates();
    void settle_gate(PartIndex part);
    [[nodiscard]] bool lets_through(PartIndex part, const Ball& ball, double time) const;
    [[nodiscard]] bool meet_gate(BallIndex i, PartIndex part, double time);
    void leave_gate(BallNumber ball, PartIndex part, double time);
    [[nodiscard]] double distance_to(PartIndex part, Vec2 center, double radius, const Pose& pose) const;

    // Predictions (continuous_predict.cpp).
    void predict(BallIndex i, double time);
    void predict_together(std::span<const BallIndex> balls, double time);
    void predict_with(BallIndex i, double time, auto&& each_other);
    void predict_features(BallIndex i, double time);
    [[nodiscard]] bool slides_to(const Mover& mover, const Ball& ball, const Feature& feature) const;
    [[nodiscard]] static bool glides_over(const Mover& mover, const Feature& feature, const Pose& pose);
    void predict_ball(BallIndex i, BallIndex j, double time);
    void predict_flying(BallIndex i, BallIndex j, double time);
    void predict_loss(BallIndex i, double time);
    void enter_cell(BallIndex i);
    void schedule(BallIndex i);
    void offer(BallIndex i, double time, Next next, std::uint32_t met = 0, std::uint32_t met_changes = 0);
    [[nodiscard]] double sense_time(PartIndex part, const Ball& ball, const Path& path, double time,
                                    bool inside) const;
    [[nodiscard]] bool ignores(const Feature& feature, const Ball& ball) const;

    // Paths, and what a ball rests on (continuous_paths.cpp).
    struct Support {
        RestingContact contact;
        bool pressed = false;
        Vec2 way{};        ///< in which it leads the ball, unit
        double ahead = 0;  ///< how far, m
    };
    void set_out(BallIndex i, double time);
    void list_in_cell(BallIndex i, double time);
    void cover_way(BallIndex i, double time);
    [[nodiscard]] bool beside_moving_part(BallIndex i);
    void find_ways(const Ball& ball, double time);
    [[nodiscard]] static bool goes_before(const Support& support, const Support& other);
    void find_supports(BallIndex i, double time);
    void note_glides(Mover& mover) const;
    [[nodiscard]] bool holds_alone(const Support& support, const Ball& ball) const;
    void choose_support(BallIndex i, double time);
    void stay_between(BallIndex i, double time);

    // Events (continuous_events.cpp).
    void handle(BallIndex i);
    static void advance(Ball& ball, const ConstrainedPath& way, double time);
    [[nodiscard]] bool leads_on(const Impact& impact, const Ball& ball) const;
    void hit_feature(BallIndex i, double time);
    void hit_ball(BallIndex i, double time);
    void lose(BallIndex i, double time);
    void sense(BallIndex i, double time);
    void release(PartIndex part, double time);
    void go_on(BallIndex i, double time);
    [[nodiscard]] bool inside(BallNumber ball, PartIndex part) const;
    void set_inside(BallNumber ball, PartIndex part, bool inside);
    void report(double time, EventKind kind, const Ball& ball, Other other, const Impact& impact, Vec2 point);
    void wake_carried(BallIndex i, double time);

    // For those who look inside (continuous_trace.cpp).
    [[nodiscard]] std::string_view name_of_next(BallIndex i) const;
    void trace_next(TraceItem& item, BallIndex i) const;
    void trace_paths(bool all_set_out);
    void trace_event(BallIndex i);
    void trace_tick(double time, double duration);

    const Scene& scene_;
    const Layout& layout_;
    SolverSettings settings_;
    Drive drive_;
    double slow_;  ///< m/s: members of an island that come together no faster are left to its ticks
    std::vector<Feature> features_;
    BoxIndex ranges_;                                      ///< of features
    std::vector<std::vector<PrimitiveIndex>> primitives_;  ///< by part; of sensors and gates only
    std::vector<Sensed> inside_;                           ///< balls in sensors and open gates, in order

    // Of the window.
    Table* table_ = nullptr;
    StepRecord* record_ = nullptr;
    double start_ = 0;            ///< s, on the table's clock; all other times count from there
    double dt_ = 0;               ///< its length
    double after_end_ = 0;        ///< the next number
    double read_at_ = 0;          ///< where it was read last
    std::vector<Ball> bodies_;    ///< each at its last event
    std::vector<Event> pending_;  ///< not written yet
    bool set_out_ = false;        ///< all balls have their paths
    bool any_awake_ = false;
    std::uint64_t events_ = 0, search_steps_ = 0;
    double next_tick_ = 0;
    bool any_pressed_ = false, any_creeps_ = false;
    std::uint32_t batch_ = 0;

    // Scratch, kept to save allocations.
    std::vector<Turning> turnings_;  ///< by part
    std::vector<Mover> pool_;        ///< with the room that their lists have
    std::span<Mover> movers_;        ///< the first of the pool, by place in balls_
    std::vector<Flying> flying_;     ///< by place
    NextEvents next_events_;
    Cells cells_;
    std::vector<Support> supports_;
    ContactSolver contact_solver_;
    /// Of the last tick in this window: of primitive a or ball a on ball b, by index.
    RememberedForces part_forces_, ball_forces_;
    double deepest_ = 0;                 ///< m, of the overlaps of balls in islands
    std::vector<BallIndex> members_;     ///< of the islands at hand, in order
    std::vector<BallIndex> creeping_;    ///< since the tick at hand
    std::vector<BallIndex> woken_;       ///< at the event at hand
    std::vector<BallIndex> overlapped_;  ///< by members, and flying
    std::vector<BallIndex> rank_;        ///< of a ball among those read
    std::vector<Pair> pairs_;
    std::array<State, 2> starts_;  ///< of the window, and of the one that is kept
    std::size_t current_ = 0, kept_ = 0;
};

}  // namespace flipside::custom

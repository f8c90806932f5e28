#pragma once
/// The continuous solver: every ball flies its exact path to its next event, events are handled in order of
/// time, and only the balls involved are predicted again (Alder and Wainwright 1959; Lubachevsky 1991, "How
/// to simulate billiards and similar systems"). There is no error but rounding, and none that grows with dt.
///
/// It works in windows of time. At the start of a window all balls set out; then it is run to any instants in
/// it, and read there. How often it is read changes no bit. What a ball rests on follows from where it is and
/// how it moves at the start, so a window can be made again from the state of the world there.
///
/// One queue holds the next event of each ball; a count per ball voids entries that were overtaken. A ball
/// that surely flies free for a while (clearance.hpp) or sleeps takes no part until something happens to it.
/// Balls find each other in a hierarchical grid of the bounds of their paths.
///
/// A slow contact (approach below rest_speed, or a hop too short to matter) holds: see holding.hpp. Balls
/// that press on each other, or lie deep in each other, cannot be ordered by time. Such a cluster, or a ball
/// for which events pile up without time passing or without an impact that counts, or whose hold has no end
/// that a search finds, or all when `max_impacts` or the steps of searches are exceeded, are given to the
/// discrete solver for that one window: it is begun again without them. Between its ends they are read on
/// straight lines. Statistics count them as handed_over.

#include "custom/broad_phase/hierarchical_grid.hpp"
#include "custom/continuous/candidates.hpp"
#include "custom/continuous/clearance.hpp"
#include "custom/continuous/glides.hpp"
#include "custom/continuous/holding.hpp"
#include "custom/discrete/discrete_solver.hpp"

namespace flipside::custom {

class ContinuousSolver {
  public:
    /// Keeps references to the table's scene, to layout and to the other solver.
    ContinuousSolver(const Table& table, const Layout& layout, const SolverSettings& settings,
                     DiscreteSolver& discrete);

    /// Begins a window of time: the balls set out at the table's time, for `length` seconds. Until the end of
    /// the window the table's clock and parts are the caller's, its gates and targets the solver's.
    void begin(Table& table, std::span<const Ball> balls, double length, StepRecord& record);
    /// Handles the events up to `until`, in seconds since the window's start. False where balls have to be
    /// handed over and the window was read already: then nothing is changed, and another window is to begin
    /// where it was read last.
    [[nodiscard]] bool run(double until, BroadPhase& broad, StepRecord& record);
    /// Where the balls are `time` seconds after the window's start, which run() has reached; lost ones are
    /// left out. Writes the events up to there that were not written yet; none gets a time after `now`.
    void read(double time, double now, std::vector<Ball>& balls);
    /// The same at the end of the window, after a run to there. Another one is to begin.
    void end(double now, std::vector<Ball>& balls);

    /// The state of the world at the window's start.
    [[nodiscard]] const State& start() const { return start_state_; }
    /// Whether nothing happens in this window: all balls fly free or sleep on.
    [[nodiscard]] bool quiet() const { return !any_active_; }
    /// Pairs of pieces and awake balls that are near each other, as a broad phase gives them; `balls` as they
    /// were read last.
    [[nodiscard]] std::span<const Pair> find_pairs(std::span<const Ball> balls);
    /// Makes room for so many balls.
    void reserve(std::size_t balls);
    /// Forgets what it noted of sensors and gates: they are found anew from where the balls are.
    void reset(Table& table, std::vector<Ball>& balls);

  private:
    enum class Next : std::uint8_t { nothing, feature, ball, look_again, sense, leave_bounds };
    using Place = std::uint32_t;  ///< of a ball in the list

    /// What the solver knows of a ball beside the Ball itself. What every step looks at comes first.
    struct Mover {
        BallNumber number = 0;
        bool active = false;  ///< takes part in this step: has a path that may meet something
        bool clear = false;   ///< touches nothing when the step begins
        bool lies = false;    ///< asleep where nothing turns
        bool handed_over = false;
        bool lost = false;
        bool cut = false;  ///< by something ahead was the time for which it flies free
        /// s, from the end of the last step on: flies free, if it is still there and so fast.
        double free = 0;
        Vec2 left_at, left_with;

        std::uint32_t changes = 0;  ///< of its path
        std::uint32_t predictions = 0;
        Next next = Next::nothing;
        double next_time = 0;
        std::uint32_t met = 0;          ///< FeatureIndex, Place or PartIndex by `next`
        std::uint32_t met_changes = 0;  ///< the other ball's, when this was predicted
        double last_time = -1;          ///< of its last event
        int stalled = 0;                ///< events at that very time
        int idle = 0;                   ///< events since its last impact that counts
        const Feature* held = nullptr;  ///< what it rests on
        const Feature* left = nullptr;  ///< what it just let go
        Glides glides;                  ///< faces that it flies along
        Candidates near;
        HeldPath way;  ///< from its last event on
    };
    /// What happens at the same time is taken in an order that does not depend on who predicted it.
    struct Entry {
        double time;
        std::uint64_t order;  ///< first what meets no ball; then by the first ball, then by the second
        Place mover;
        std::uint32_t prediction;
        friend bool operator>(const Entry& a, const Entry& b) {
            return a.time != b.time ? a.time > b.time : a.order > b.order;
        }
    };
    [[nodiscard]] static std::uint64_t order_of(Place i, const Mover& mover);

    // The window as a whole (continuous_window.cpp).
    void take_places();
    void set_out_all(BroadPhase& broad);
    void handle_until(double time);
    void note_flags();
    void restore_flags(const State& before);
    [[nodiscard]] Ball ball_at(Place i, double time, const Stretch& since_start) const;
    void report_until(double time, double now);
    void drop_lost();

    // What happens at its start, and which pairs are near when it is read (continuous_solver.cpp).
    void prepare_movers();
    void come_out(Place i);
    void find_piles();
    [[nodiscard]] bool piled(Place i, Place j) const;
    void list_active();
    /// Whether any two paths, of which one is of a ball that takes part, may cross.
    [[nodiscard]] bool any_paths_cross() const;
    /// Around all that touches a ball on its path.
    [[nodiscard]] Box touching_bounds(Place i) const;
    void run_discrete(BroadPhase& broad);
    void pair_with_parts(std::span<const Ball> balls, Place i);
    void pair_with_balls(std::span<const Ball> balls, Place i, double margin);
    [[nodiscard]] double pressing(Place i, Place j, double time) const;
    void hand_over(Place i);

    // Balls that need no search (continuous_free.cpp).
    void find_active();
    [[nodiscard]] bool still_free(Place i) const;
    void find_free_time(Place i);
    void go_free(Place i);
    [[nodiscard]] double free_of_balls(Place i, double until) const;
    void activate_all();

    // Gates (continuous_gates.cpp).
    void settle_gates(Table& table, std::vector<Ball>& balls);
    void settle_gate(Table& table, std::vector<Ball>& balls, PartIndex part);
    [[nodiscard]] bool lets_through(PartIndex part, const Ball& ball, double time) const;
    [[nodiscard]] bool meet_gate(Place i, PartIndex part, double time);
    void leave_gate(BallNumber ball, PartIndex part, double time);
    void open_again();
    [[nodiscard]] double distance_to(PartIndex part, Vec2 center, double radius, const Pose& pose) const;

    // Predictions (continuous_predict.cpp).
    void set_out(Place i, double time);
    void predict(Place i, double time);
    void predict_features(Place i, double time);
    [[nodiscard]] bool slides_to(const Mover& mover, const Ball& ball, const Feature& feature) const;
    [[nodiscard]] static bool glides_over(const Mover& mover, const Feature& feature, const Pose& pose);
    void predict_balls(Place i, double time);
    void predict_loss(Place i, double time);
    void offer(Mover& mover, double time, Next next, std::uint32_t met = 0, std::uint32_t met_changes = 0);
    [[nodiscard]] double sense_time(PartIndex part, const Ball& ball, const Path& path, double time,
                                    bool inside) const;
    [[nodiscard]] bool beside_moving_part(Place i);
    [[nodiscard]] bool ignores(const Feature& feature, const Ball& ball) const;

    // Resting contacts (continuous_predict.cpp).
    struct Grip {
        Hold hold;
        bool pressed = false;
        Vec2 way{};        ///< in which it leads the ball, unit
        double ahead = 0;  ///< how far, m
    };
    void find_ways(const Ball& ball, double time);
    [[nodiscard]] static bool goes_before(const Grip& grip, const Grip& other);
    void find_grips(Place i, double time);
    void note_glides(Mover& mover) const;
    void take_hold(Place i, double time);

    // Events (continuous_events.cpp).
    void handle(Place i);
    static void advance(Ball& ball, const HeldPath& way, double time);
    [[nodiscard]] bool leads_on(const Impact& impact, const Ball& ball) const;
    void hit_feature(Place i, double time);
    void hit_ball(Place i, double time);
    void lose(Place i, double time);
    void sense(Place i, double time);
    void release(PartIndex part, double time);
    void go_on(Place i, double time);
    [[nodiscard]] bool inside(BallNumber ball, PartIndex part) const;
    void set_inside(BallNumber ball, PartIndex part, bool inside);
    void report(double time, EventKind kind, const Ball& ball, Other other, const Impact& impact, Vec2 point);

    const Scene& scene_;
    const Layout& layout_;
    SolverSettings settings_;
    DiscreteSolver& discrete_;
    Drive drive_;
    std::vector<Feature> features_;
    BoxIndex ranges_;                              ///< of features
    std::vector<std::vector<PieceIndex>> pieces_;  ///< by part; of sensors and gates only
    std::vector<Sensed> inside_;                   ///< balls in sensors and open gates, in order
    bool settled_ = false;                         ///< of no ball it is unknown whether it is at a gate
    Clearance clearance_;
    std::unique_ptr<BroadPhase> few_;  ///< for what is handed over

    // Of the window.
    Table* table_ = nullptr;
    StepRecord* record_ = nullptr;
    double start_ = 0;            ///< s, on the table's clock; all other times count from there
    double dt_ = 0;               ///< its length
    double read_at_ = 0;          ///< where it was read last
    std::vector<Ball> bodies_;    ///< each at its last event
    std::vector<Event> pending_;  ///< not written yet
    bool set_out_ = false;        ///< all balls have their paths
    bool ended_ = false;          ///< the last window was not given up
    Stretch stretch_{0, 0};       ///< dt
    bool parts_changed_ = true;   ///< how a part stands or turns is not as in the last step
    bool any_active_ = false;
    std::uint64_t events_ = 0, search_steps_ = 0;  ///< in all attempts
    bool spoilt_ = false;                          ///< this attempt found balls to hand over
    bool apart_ = false;  ///< nothing happened yet, and on their ways no two balls come near each other

    // Scratch, kept to save allocations.
    std::vector<Turning> turnings_;   ///< by part
    std::vector<Mover> pool_;         ///< with the room that their lists have
    std::span<Mover> movers_;         ///< the first of the pool, by place in balls_
    std::vector<Entry> queue_;        ///< a heap
    std::vector<Place> active_room_;  ///< scratch of active_
    std::span<const Place> active_;   ///< of those who take part, in order
    HierarchicalGrid paths_;          ///< bounds of each ball's path until the end of the step, by place
    std::vector<Place> near_;         ///< scratch: what a query found
    std::vector<Grip> grips_;
    std::vector<Ball> handed_;
    std::vector<Place> rank_;  ///< of a ball among those read
    std::vector<Pair> pairs_;
    State start_state_;                  ///< of the window
    State last_read_;                    ///< without balls; where the window was read
    std::vector<Sensed> inside_before_;  ///< the run under way
};

}  // namespace flipside::custom

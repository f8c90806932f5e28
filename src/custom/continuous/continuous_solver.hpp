#pragma once
/// The continuous solver: every ball flies its exact path to its next event inside the step, events are
/// handled in order of time, and only the balls involved are predicted again (Alder and Wainwright 1959;
/// Lubachevsky 1991, "How to simulate billiards and similar systems"). There is no error but rounding, and
/// none that grows with dt.
///
/// One queue holds the next event of each ball; a count per ball voids entries that were overtaken. A ball
/// that surely flies free for a while (clearance.hpp) or sleeps takes no part until something happens to it.
/// Nothing of a step is kept for the next one but lists that only save work: what a ball rests on follows
/// from where it is and how it moves, so a restored world continues with the same bits.
///
/// A slow contact (approach below rest_speed, or a hop too short to matter) holds: see holding.hpp. Balls
/// that press on each other, or lie deep in each other, cannot be ordered by time. Such a cluster, or a ball
/// for which events pile up without time passing or without an impact that counts, or whose hold has no end
/// that a search finds, or all when `max_impacts` or the steps of searches are exceeded, are given to the
/// discrete solver for that one step: the step is begun again without them. Statistics count them as
/// handed_over.

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

    /// Moves the balls by dt; the table's clock stays, its gates and targets may change. Lost balls are
    /// removed (or kept and noted as reported).
    void step(Table& table, std::vector<Ball>& balls, double dt, BroadPhase& broad, StepRecord& record);

    /// Whether nothing happened in the last step: all balls flew free or slept on.
    [[nodiscard]] bool quiet() const { return !any_active_; }
    /// Pairs of pieces and awake balls that are near each other after a step, as a broad phase gives them.
    [[nodiscard]] std::span<const Pair> near_pairs() const { return pairs_; }
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

    // The step as a whole (continuous_solver.cpp).
    void begin();
    void take_places();
    bool attempt(BroadPhase& broad);
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
    void roll_back(std::size_t events);
    void finish();
    void drop_lost();
    void find_pairs();
    void pair_with_parts(Place i);
    void pair_with_balls(Place i, double margin);
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
    void advance(Place i, double time);
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

    // Of the step being made.
    Table* table_ = nullptr;
    std::vector<Ball>* balls_ = nullptr;
    StepRecord* record_ = nullptr;
    double dt_ = 0;
    Stretch stretch_{0, 0};      ///< dt
    bool parts_changed_ = true;  ///< how a part stands or turns is not as in the last step
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
    std::vector<Ball> at_start_, handed_;
    std::vector<PartState> parts_at_start_;
    std::size_t reported_at_start_ = 0;
    std::vector<Pair> pairs_;
    std::vector<Sensed> inside_at_start_;
    std::vector<Pressing> pressings_at_start_;
    std::vector<Blocked> blocked_at_start_;
};

}  // namespace flipside::custom

#pragma once
/// The discrete solver, as in the classic toy: several times a step, all balls fly on and then what
/// overlaps is answered, round by round.
///
///     motion_iterations × ( broad phase; fly; collision_iterations × (parts, balls); gates )
///
/// Flight is exact (flight.hpp), and impacts act from the moment of touch (response.hpp), so what a single
/// ball does is good to rounding off straight surfaces and to second order off curved ones. A ball that
/// could sink deep into a part during one flight is stopped at the surface instead (sweep.hpp). Two balls
/// that passed through each other in one flight are turned back to where they touched.

#include "custom/broad_phase/near_list.hpp"
#include "custom/discrete/pile.hpp"
#include "custom/layout.hpp"
#include "custom/response.hpp"
#include "custom/settings.hpp"
#include "custom/touch_list.hpp"
#include "world/events.hpp"
#include "world/statistics.hpp"

namespace flipside::custom {

/// What a step leaves behind for its readers.
struct StepRecord {
    std::vector<Event> events;
    std::vector<Sensed> crossed;  ///< sensors met
    Statistics statistics;
    double broad_seconds = 0, flight_seconds = 0, contact_seconds = 0, report_seconds = 0;
};

/// Overlaps up to this, in radii, are rounding and left alone.
inline constexpr double overlap_slop = 1e-9;

class DiscreteSolver {
  public:
    /// Keeps references to scene and layout.
    DiscreteSolver(const Scene& scene, const Layout& layout, const SolverSettings& settings);

    /// Moves the balls by dt; the table's clock stays, its gates and targets may change.
    void step(Table& table, std::vector<Ball>& balls, double dt, BroadPhase& broad, StepRecord& record);

    /// Makes room for so many balls.
    void reserve(std::size_t balls);

    /// The pairs found near each other in the last step; still good after it while they hold.
    [[nodiscard]] NearList& near() { return near_; }
    [[nodiscard]] const NearList& near() const { return near_; }

  private:
    /// A ball (by place) and a piece whose boxes overlap.
    struct Candidate {
        std::uint32_t ball;
        PieceIndex piece;
    };
    struct BallPair {
        std::uint32_t a, b;  ///< a < b
    };
    /// One motion iteration.
    struct Span {
        double begin, end;  ///< s from the start of the step
        [[nodiscard]] double duration() const { return end - begin; }
    };

    void start_flights(double duration);
    void find_candidates();
    void finish_flights(double duration);
    [[nodiscard]] PieceIndex moving_pieces() const {
        return layout_.size() - static_cast<PieceIndex>(layout_.still_proxies().size());
    }
    /// The farthest a ball can get.
    [[nodiscard]] double way(const Ball& ball, double duration) const {
        return (length(ball.velocity) + pull_ * duration) * duration;
    }
    [[nodiscard]] Box room_of_part(std::size_t moving) const;
    [[nodiscard]] Box room_of_ball(std::uint32_t place) const;
    [[nodiscard]] std::span<const Candidate> look_around(const Ball& ball, double reach);
    void fly(Ball& ball, std::span<const Candidate> near, double duration);
    [[nodiscard]] double first_touch_of(const Ball& ball, PieceIndex index, double at, double duration) const;
    [[nodiscard]] bool sinks(double approach, const Ball& ball, double duration) const;
    // Rounds of response (discrete_contacts.cpp).
    void collide();
    [[nodiscard]] bool changed(std::uint32_t place) const;
    bool collide_parts();
    bool collide_ball_with_parts(std::uint32_t place, std::span<const Candidate> near);
    bool collide_balls();
    void respond_to(Ball& ball, PieceIndex index, const Touch& touch, double at, double& flown);
    bool turn_back(BallPair pair);
    bool collide(BallPair pair, Vec2 normal);
    void keep_sides();
    void keep_side(std::uint32_t place);
    [[nodiscard]] const Candidate* first_crossed(const Ball& ball, Vec2 from, std::span<const Candidate> near,
                                                 double& time) const;
    void report(const Ball& ball, Other other, const Impact& hit, Vec2 point, double time);
    [[nodiscard]] Touch touch_at_end(const Ball& ball, PieceIndex index);
    [[nodiscard]] Vec2 surface_velocity(PieceIndex index, double ahead, Vec2 point) const;
    [[nodiscard]] double rest_approach(Vec2 normal) const;
    [[nodiscard]] bool strikes(const Ball& ball, PieceIndex index, const Touch& touch) const;
    // Piles (discrete_piles.cpp).
    [[nodiscard]] bool press(BallPair pair, bool left_over) const;
    void put_in_pile(BallPair pair);
    void find_piles();
    void solve_piles();
    void pile_balls_on_balls();
    void pile_balls_on_parts();
    void pile_on_parts(std::uint32_t place, std::span<const Candidate> near);
    void keep_pressings();
    void watch_gates();
    void watch_sensors();

    const Scene& scene_;
    const Layout& layout_;
    SolverSettings settings_;
    double pull_;  ///< m/s², amount of gravity
    std::vector<PartIndex> gates_;
    bool any_sensor_;

    // Of the step being made.
    Table* table_ = nullptr;
    std::vector<Ball>* balls_ = nullptr;
    StepRecord* record_ = nullptr;
    BroadPhase* broad_ = nullptr;
    double dt_ = 0;
    Span span_{};

    NearList near_;

    // Scratch, kept to save allocations; nothing in it outlives a motion iteration.
    std::vector<Proxy> moving_;
    std::vector<std::uint32_t> waiting_;     ///< balls whose flight a part may stop
    std::span<const Candidate> candidates_;  ///< by ball
    std::span<const BallPair> ball_pairs_;
    std::vector<Candidate> candidate_room_, touching_room_;
    std::vector<BallPair> ball_pair_room_;
    std::vector<Candidate> around_;  ///< what look_around() found
    std::vector<Handle> found_;      ///< what the broad phase found for it
    std::vector<Vec2> started_;      ///< where each ball was before it flew
    /// An overlap with a part; the deepest come first.
    struct Deep {
        double separation;
        PieceIndex piece;
        friend auto operator<=>(const Deep&, const Deep&) = default;
    };
    std::vector<Deep> deep_;
    int round_ = 0;
    std::vector<int> changed_in_;  ///< per ball, the last round that moved it
    std::vector<double> flown_;    ///< per ball, s of free flight up to the end of the iteration
    std::vector<char> in_pile_;    ///< per ball
    bool any_pile_ = false;
    std::vector<char> pushed_;  ///< per ball: by what may not have heeded what lies behind it
    std::vector<BallPair> pressing_;
    Pile pile_;
    std::vector<Pressing> pressed_;  ///< of the pairs of balls in pile_
};

}  // namespace flipside::custom

#pragma once
/// The discrete solver, as in the classic toy: several times a step, balls fly on and then what overlaps is
/// answered, round by round.
///
///     broad phase; whose turn comes when
///     motion_iterations × ( fly; pairs; collision_iterations × (parts, balls); gates )
///     the others fly
///
/// Most balls meet nothing in most steps: they fly once, the whole step. What is done several times is done
/// only for those that are engaged, each from the flight on in which it may first touch something
/// (discrete_turns.cpp).
///
/// Flight is exact (flight.hpp), and impacts act from the moment of touch (response.hpp), so what a single
/// ball does is good to rounding off straight surfaces and to second order off curved ones. A ball that
/// could sink deep into a part during one flight is stopped at the surface instead (sweep.hpp). Two balls
/// that passed through each other in one flight are turned back to where they touched.

#include <optional>

#include "custom/broad_phase/near_list.hpp"
#include "custom/discrete/pile.hpp"
#include "custom/discrete/place_set.hpp"
#include "custom/flight.hpp"
#include "custom/layout.hpp"
#include "custom/response.hpp"
#include "custom/settings.hpp"
#include "custom/step_record.hpp"
#include "custom/tolerances.hpp"

namespace flipside::custom {

/// Those who fly free keep at least this far from everything, in radii: farther than what counts as touch or
/// as pressing.
inline constexpr double berth = 2e-3;

class DiscreteSolver {
  public:
    /// Keeps references to scene and layout.
    DiscreteSolver(const Scene& scene, const Layout& layout, const SolverSettings& settings);

    /// Moves the balls by dt, except for those who fly free: land() follows. The table's clock stays, its
    /// gates and targets may change.
    void step(Table& table, std::vector<Ball>& balls, double dt, BroadPhase& broad, StepRecord& record);
    /// Those who fly free do so, and each ball is shown to `see(place, ball)` while it is at hand.
    void land(std::span<Ball> balls, auto&& see) {
        constexpr std::uint32_t block = 64;
        const auto is_free = [&](std::uint32_t place) { return role_[place] == Role::free; };
        for (std::size_t first = 0; first < balls.size(); first += block) {
            const std::size_t last = std::min(first + block, balls.size());
            for (const std::uint32_t place : sift(Places{first, last}, places_, is_free))
                fly_freely(balls[place], scene_.gravity, marks_.back());
            for (std::size_t place = first; place < last; ++place) see(place, balls[place]);
        }
    }

    /// Makes room for so many balls.
    void reserve(std::size_t balls);

    /// All that may touch after the last step, and more: pieces and balls by handle, in order.
    [[nodiscard]] std::span<const Pair> part_pairs() const { return part_pairs_; }
    [[nodiscard]] std::span<const Pair> ball_pairs() const { return ball_pairs_; }
    /// The list that they come from.
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
    /// Of two balls on their free ways, with their berth. The one's way as seen from the other is straight.
    struct Approach {
        double apart;    ///< m², squared distance at the start, less that of a touch
        double closing;  ///< m², −distance · way
        double square;   ///< m², of the way's length
        [[nodiscard]] bool touches() const {
            return (apart <= 0) | ((closing > 0) & (closing * closing >= square * apart));
        }
        /// Of the way, until they do.
        [[nodiscard]] double part() const {
            if (apart <= 0) return 0;
            return apart / (closing + std::sqrt(std::max(0.0, closing * closing - square * apart)));
        }
    };
    /// One motion iteration.
    struct Span {
        double begin, end;  ///< s from the start of the step
        [[nodiscard]] double duration() const { return end - begin; }
    };

    // Who takes part (discrete_turns.cpp).
    void find_turns();
    [[nodiscard]] NearList::Check place_all();
    void take_turns(std::span<const Pair> with_parts, std::span<const Pair> of_balls);
    [[nodiscard]] std::size_t first_flight_to(PieceIndex piece, const Ball& ball) const;
    [[nodiscard]] Approach approach_of(const Ball& a, const Ball& b) const;
    [[nodiscard]] std::size_t flight_of(const Approach& approach) const;
    [[nodiscard]] Box free_way_of(const Ball& ball) const;
    void let_doze(std::uint32_t place);
    void lie_still(std::uint32_t place);
    void engage(std::uint32_t place);
    void engage_due(std::size_t flight);
    void engage_met();
    void meet(std::uint32_t met, std::uint32_t by);
    void link(std::span<const Pair> of_balls);
    void widen(std::uint32_t place, const Box& flight);
    void seek_company();
    void seek_company_of(std::uint32_t place);
    void finish_step();
    void start_flights(std::size_t flight);
    void start_flight(std::uint32_t place);
    void start_over(std::uint32_t place);
    void find_candidates();
    void finish_flights(double duration);
    [[nodiscard]] PieceIndex moving_pieces() const {
        return layout_.size() - static_cast<PieceIndex>(layout_.still_proxies().size());
    }
    /// The farthest a ball can get.
    [[nodiscard]] double way(const Ball& ball, double duration) const {
        return (length(ball.velocity) + pull_ * duration) * duration;
    }
    [[nodiscard]] Handle first_ball() const { return layout_.size(); }
    [[nodiscard]] std::uint32_t place_of(Handle ball) const { return ball - first_ball(); }
    [[nodiscard]] BallPair places_of(Pair pair) const { return {place_of(pair.a), place_of(pair.b)}; }
    /// What a flight and its rounds will read of a ball.
    void prepare(std::uint32_t soon) const {
        fetch_flight((*balls_)[soon]);
        fetch(so_far_[soon]);
    }
    void prepare(BallPair soon) const {
        prepare(soon.a);
        prepare(soon.b);
    }
    [[nodiscard]] std::size_t flights() const { return marks_.size() - 1; }
    [[nodiscard]] const Proxy& proxy_of_ball(std::uint32_t place) const {
        return moving_[moving_pieces() + place];
    }
    [[nodiscard]] const Proxy& proxy_of(PieceIndex piece) const {
        // Chosen without a branch: nothing foretells which.
        const std::vector<Proxy>& still = layout_.still_proxies();
        const Proxy* const kinds[] = {still.data(), moving_.data()};
        const std::size_t begins[] = {0, still.size()};
        const auto kind = static_cast<std::size_t>(piece >= still.size());
        return kinds[kind][piece - begins[kind]];
    }
    /// What a ball and its berth can't leave, wherever it turns, if nothing gives it speed.
    [[nodiscard]] Box reach_of(const Ball& ball, double duration) const {
        return bounds_of(ball.position, (1 + berth) * ball.radius + way(ball, duration));
    }
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
    bool collide(BallPair pair);
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
    bool any_sensor_;

    // Of the step being made.
    Table* table_ = nullptr;
    std::vector<Ball>* balls_ = nullptr;
    StepRecord* record_ = nullptr;
    BroadPhase* broad_ = nullptr;
    double dt_ = 0;
    Span span_{};

    NearList near_;

    // Scratch, kept to save allocations; nothing in it outlives a step.
    /// A bit each, so that those of a pair are asked about together.
    struct Role {
        enum Is : std::uint8_t {
            free = 1,  ///< meets nobody up to now
            engaged = 2,
            asleep = 4,
            dozing = 8,  ///< asleep where it may be met
        };
    };
    [[nodiscard]] unsigned roles_of(Pair of_balls) const {
        return role_[place_of(of_balls.a)] | unsigned{role_[place_of(of_balls.b)]};
    }
    std::vector<Role::Is> role_;  ///< per ball
    /// When a ball may first touch something.
    struct Turn {
        std::size_t flight;
        std::uint32_t place;
    };
    std::vector<Turn> turns_, turn_room_;
    std::vector<std::uint32_t> engaged_, dozing_;  ///< places, in no order
    bool all_woken_ = false;                       ///< by a target
    bool any_asleep_ = false;                      ///< when the step began
    /// What each can meet in this step, by handle and in order; after it, of the engaged.
    std::vector<Pair> part_pairs_, ball_pairs_;
    /// The pairs of balls once more, as the search found them: for each ball a list of its own.
    struct Link {
        std::uint32_t other;  ///< place
        std::uint32_t next;   ///< into links_, or no_link
    };
    static constexpr std::uint32_t no_link = ~0U;
    std::vector<std::uint32_t> first_link_;  ///< per ball
    std::vector<Link> links_;
    std::vector<BallPair> meetings_;      ///< scratch
    std::vector<std::uint32_t> seeking_;  ///< engaged, but their pairs are not all listed yet
    BoxRow strays_;                       ///< kicked or woken beyond what the search knew
    std::vector<Pair> fresh_part_pairs_, fresh_ball_pairs_;  ///< that come to these
    std::vector<std::size_t> pair_places_;                   ///< scratch
    std::vector<Pair> room_;                                 ///< scratch
    std::vector<Proxy> moving_;   ///< of the table's parts for this flight; of balls for the step
    std::vector<Stretch> marks_;  ///< from the start of the step to the start of each flight, and to the end
    Stretch flight_{0, 0};        ///< one motion iteration
    std::optional<Box> swept_;    ///< by moving parts, in this flight
    std::vector<std::uint32_t> places_;      ///< scratch
    PlaceSet waiting_;                       ///< balls whose flight a part may stop
    PlaceSet all_engaged_;                   ///< the same as engaged_, in order
    std::span<const Candidate> candidates_;  ///< of these pairs, what the boxes of the flight overlap
    std::span<const BallPair> near_balls_;
    std::vector<Candidate> candidate_room_, touching_room_;
    std::vector<BallPair> near_balls_room_;
    std::vector<Candidate> around_;  ///< what look_around() found
    std::vector<Handle> found_;      ///< what the broad phase found for it
    /// What happened to an engaged ball in this flight: a line of the cache.
    struct alignas(64) SoFar {
        SingleBox reach;        ///< within it in this step, unless kicked
        SingleBox box;          ///< within it in this flight
        Vec2 start;             ///< where it was before
        double flown = 0;       ///< s of free flight up to the end
        bool is_known = false;  ///< its pairs are listed, as far as it reaches
    };
    std::vector<SoFar> so_far_;  ///< per ball
    /// What the rounds did to it: asked so often that it is kept small and together.
    struct Rounds {
        std::uint8_t changed_in = 0;  ///< the last one that moved it
        bool in_pile = false;
        bool pushed = false;  ///< by what may not have heeded what lies behind it
    };
    std::vector<Rounds> rounds_;  ///< per ball
    /// An overlap with a part; the deepest come first.
    struct Deep {
        double separation;
        PieceIndex piece;
        friend auto operator<=>(const Deep&, const Deep&) = default;
    };
    std::vector<Deep> deep_;
    int round_ = 0;
    bool any_pile_ = false;
    std::vector<BallPair> pressing_;
    Pile pile_;
    std::vector<Pressing> pressed_;  ///< of the pairs of balls in pile_
};

}  // namespace flipside::custom

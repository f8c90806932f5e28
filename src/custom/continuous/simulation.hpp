#pragma once
/// What the parts of the continuous solver share: the table, the clock of the current window, and each ball
/// with its path and its next event. Gates, Paths, Predictions, Islands and Events each work on it, and each
/// knows only those named before it; they keep references to what they are made with.

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "custom/continuous/neighbours.hpp"
#include "custom/continuous/resting_contact.hpp"
#include "custom/layout.hpp"
#include "custom/settings.hpp"
#include "custom/step_record.hpp"

namespace flipside::custom {

enum class EventType : std::uint8_t { none, feature, ball, path_end, sensor, leave_bounds };

/// s: time step of the island solver, unless balls are small.
inline constexpr double longest_tick = 1.0 / 240;
/// Radii of the smallest ball: how far a slow approach may lead in a tick. Ticks are halved until this holds,
/// at most most_halvings times.
inline constexpr double farthest_approach = 0.02;
inline constexpr int most_halvings = 3;
/// Radii: a member that moves no farther than this in a long tick creeps.
inline constexpr double creep_distance = 0.02;

/// The data of a ball that predictions of other balls read, in one cache line.
struct alignas(64) HotState {
    Vec2 position, velocity;    ///< m and m/s, at the start of its path
    double start = 0;           ///< of its path, s
    double radius = 0;          ///< m
    std::uint32_t version = 0;  ///< incremented whenever its path changes
    std::uint32_t batch = 0;    ///< of Predictions: in which it was predicted last
    bool ballistic = false;     ///< its path is a flight under gravity and drag alone
    bool in_island = false;     ///< in resting contact with another ball, or jammed
    bool lost = false;          ///< has left the bounds, and is in no cell
    bool creeps = false;        ///< in an island, and hardly moves until its next long tick
    bool in_solve = false;      ///< is a body of the current solve
};

/// When a ball may be within sleep_distance of others, on its path and theirs.
struct NearTimes {
    double until = -INFINITY;  ///< s: so long it may be near a ball that it leaves
    double from = INFINITY;    ///< s: from then on it may be near a ball that it approaches
    bool part = false;         ///< it may be near a part before cell_exit

    [[nodiscard]] bool ball_at(double time) const { return time <= until || time >= from; }
};

/// All other data that the solver keeps of a ball beside the Ball itself; first what a read-out needs.
struct Particle {
    ConstrainedPath motion;     ///< since its last event
    bool on_tick_path = false;  ///< in an island, on the path that the last tick gave it
    bool jammed = false;        ///< since the last regular tick: Islands::solve_jammed()
    bool frozen = false;        ///< stays in place without events until the next tick: Islands::freeze()
    double last_loaded = 0;     ///< s: when it last had a load from a ball, or from two sides
    int loads = 0;              ///< contacts that carry a force; those with balls count twice
    Vec2 velocity_begin{}, velocity_end{};  ///< m/s, at the ends of a tick; the parabola between has others
    EventType next = EventType::none;
    double next_time = 0;               ///< s; after_end where nothing happens
    std::uint32_t partner = 0;          ///< FeatureIndex, BallIndex or PartIndex, according to `next`
    std::uint32_t partner_version = 0;  ///< version of the partner's path in this prediction
    double last_event = -1;             ///< s
    double last_hit = -INFINITY;        ///< s, of its last contact with a ball
    double last_driven = -INFINITY;     ///< s, of its last contact with a part that moves
    int hits = 0;                 ///< contacts with balls in a row, each within a tick of the one before
    int simultaneous_events = 0;  ///< at the time last_event
    bool meets_balls = false;     ///< in one of these events
    int idle_events = 0;          ///< since its last significant impact
    double events_until = 0;      ///< s: end of the time that its events take at least_interval each
    double cell_exit = 0;         ///< s: when it must be listed in another cell
    Box bounds{};                 ///< swept bounds of its path until cell_exit, with sleep_distance
    const Feature* resting_on = nullptr;      ///< its resting contact
    const Feature* separated_from = nullptr;  ///< the resting contact that has just ended
    TangentFaces tangent_faces{};             ///< faces along which it flies
};

struct Simulation {
    /// Keeps references to the table and the layout.
    Simulation(Table& of_table, const Layout& of_layout, const SolverSettings& with);
    Simulation(const Simulation&) = delete;
    Simulation& operator=(const Simulation&) = delete;
    ~Simulation() = default;

    void reserve(std::size_t most);
    /// Starts a window with these balls: assigns a particle to each.
    void start_with(std::span<const Ball> at_start);

    /// The ball at this time on its path, with its true velocity.
    [[nodiscard]] Ball ball_at(BallIndex i, double time) const;
    /// The same into `ball`, which may be that ball at another time of the window, or any other.
    void read(BallIndex i, double time, Ball& ball) const;
    /// Moves a ball there.
    void advance_to(BallIndex i, double time) { balls[i] = ball_at(i, time); }
    /// Velocity of a ball that was advanced along its path to this time. The velocity of a member is
    /// interpolated linearly between ticks; that of its parabola serves only to reach the solved position. A
    /// creeping member has its new velocity right after the tick.
    [[nodiscard]] Vec2 true_velocity(BallIndex i, double time) const;
    /// Where a ball in ballistic flight is.
    [[nodiscard]] Flight::Motion flying_at(const HotState& ball, double time) const {
        if (time == ball.start) return {ball.position, ball.velocity};
        return Flight{ball.position, ball.velocity, external.gravity, external.drag}.at(time - ball.start);
    }
    /// All features whose ranges overlap the box, in rising order. Valid until the next call.
    [[nodiscard]] std::span<const FeatureIndex> features_near(const Box& box);

    /// Next point after `time` on the grid of spacing `length` that ends with the window, s.
    [[nodiscard]] double next_on_grid(double time, double length) const;
    [[nodiscard]] double next_tick(double time) const { return next_on_grid(time, tick_length); }
    /// Makes a ball a member of an island. It keeps its path until the next tick, but has no slow contacts
    /// with other members.
    void join_island(BallIndex i, double time);
    /// s: time step of creeping members.
    [[nodiscard]] double long_tick_length() const { return 4 * tick_length; }
    /// Whether a member of this speed, m/s, may creep: it moves less than creep_distance in a long tick, and
    /// two of them approach no faster than in a resting contact, since those that creep have no impacts with
    /// each other and with walls.
    [[nodiscard]] bool creeps_at(double speed, const Ball& ball) const {
        return speed * long_tick_length() <= creep_distance * ball.radius && speed <= slow / 2;
    }
    void leave_island(BallIndex i) { members -= std::exchange(hot[i].in_island, false); }

    Table& table;
    const Scene& scene;
    const Layout& layout;
    SolverSettings settings;
    ExternalForces external;
    std::vector<Feature> features;
    BoxIndex ranges;  ///< of features

    // The current window. All times are relative to its start, unless they are on the table's clock.
    StepRecord* record = nullptr;       ///< of the current step
    double start = 0;                   ///< s, on the table's clock
    double end = 0;                     ///< s
    double after_end = 0;               ///< the next number after `end`
    double now = 0;                     ///< s, on the table's clock: the end of the current step
    std::uint64_t search_steps = 0;     ///< of all root searches
    double tick_length = longest_tick;  ///< s
    double slow = 0;     ///< m/s: slower approaches inside an island are resting contacts, not impacts
    double tick_at = 0;  ///< s: the next tick, if any_in_island
    bool any_in_island = false;
    std::uint64_t members = 0;  ///< of islands

    // Per ball.
    std::vector<Ball> balls;        ///< each at the start of its path
    std::span<Particle> particles;  ///< the first of the pool
    std::vector<HotState> hot;
    std::vector<NearTimes> near;

    std::vector<Turning> turnings;  ///< per part
    Cells cells;

  private:
    void choose_tick();

    std::vector<Particle> pool_;               ///< keeps the memory of their Taylor polynomials
    std::vector<FeatureIndex> near_features_;  ///< buffer of features_near()
};

/// Moves a ball along a path to `time`.
void advance(Ball& ball, const ConstrainedPath& motion, double time);

}  // namespace flipside::custom

#pragma once
/// The exact engine: every ball follows its path until its next event, events are handled in order of time,
/// and only the balls involved are predicted again. One queue, a clock per ball, and version numbers that
/// invalidate outdated predictions: Lubachevsky 1991, "How to simulate billiards and similar systems".
///
/// Positions at the end of a step are read off the paths. So a trajectory does not depend on the step, bit
/// for bit, except for the times of controls and a clock that is reset once a second.
///
/// Rules where the physical model leaves a choice: impacts at one instant are solved pair by pair, first
/// those with parts, and each in the order of the numbers of the balls; bounces lower than the rounding of a
/// radius become resting contacts (the end of a Zeno sequence if rest_speed is 0); a ball that starts inside
/// a part is moved out of it and keeps its velocity. Balls in resting contact with each other are a static
/// heap if their weights can be in equilibrium (heaps.cpp). Cases without an exact solution throw Refusal:
/// moving balls in resting contact with each other, an impact on a heap, a ball between two parts of which
/// one moves, and impacts without end.

#include <functional>
#include <map>
#include <optional>
#include <string>

#include "reference/cells.hpp"
#include "reference/equilibrium.hpp"
#include "reference/exact.hpp"
#include "reference/region.hpp"
#include "reference/response.hpp"
#include "reference/resting_contact.hpp"
#include "world/limits.hpp"
#include "world/refusal.hpp"

namespace flipside::reference {

/// Radii: largest gap and overlap of a contact in a heap. Heaps that approximate engines leave at rest have
/// contacts of this size.
constexpr double heap_gap = 2e-3, heap_overlap = 1e-2;

template <class R>
class Simulation final : public Exact {
  public:
    explicit Simulation(std::shared_ptr<const Scene> scene);

    void load(const State& state) override;
    void apply(const Control& control) override;
    void add(const Ball& ball) override;
    void remove(BallNumber number) override;
    void set_velocity(BallNumber number, Vec2 velocity) override;
    void begin(double seconds) override;
    [[nodiscard]] bool run_until(std::chrono::steady_clock::time_point deadline) override;

    void write_to(Trace* trace) override { trace_ = trace; }
    void certify(Certificate* certificate) override;

    void read(std::vector<Ball>& balls) const override;
    [[nodiscard]] std::span<const Event> events() const override { return events_; }
    [[nodiscard]] bool open(PartIndex gate) const override { return parts_[gate].open; }
    [[nodiscard]] bool down(PartIndex target) const override { return parts_[target].down; }
    void blocked(std::vector<Blocked>& blocked) const override;
    [[nodiscard]] std::span<const BallNumber> reported_lost() const override { return reported_lost_; }
    [[nodiscard]] const Counts& counts() const override { return counts_; }
    [[nodiscard]] double distance(BallNumber number, Vec2 position) const override;
    void contacts(std::vector<Contact>& contacts) const override;
    void forecast(std::vector<Forecast>& forecasts) const override;
    void occupied(std::vector<std::pair<Box, int>>& cells) const override;

  private:
    enum class Next : std::uint8_t { nothing, feature, ball, cell, predict_again, sensor, lost };
    using BallIndex = std::uint32_t;  ///< index of a ball in particles_; it never changes
    using FeatureIndex = std::uint32_t;
    static constexpr FeatureIndex nothing = ~0U;
    static constexpr std::uint32_t outside_already =
        4;  ///< value instead of the side on which a ball is lost

    /// The line of a straight static face that a ball touches without a contact force.
    struct TangentFace {
        V<R> at, normal;  ///< normal: unit, to the ball
    };
    struct Particle {
        Ball ball;  ///< its constants: number, mass, material, layers
        R radius{}, mass{};
        Body<R> body;  ///< at the start of its path
        Path<R> path;
        R until = infinity<R>();  ///< end of the path
        bool separates = false;   ///< whether the contact ends there
        FeatureIndex support[2] = {nothing, nothing};
        V<R> support_normal;  ///< of support[0], in the pose in which its part sees it
        R support_force[2]{},
            support_friction[2]{};  ///< N, where two parts support it: normal, and along perp of that
        std::optional<std::size_t> noted_rest;  ///< its index in the certificate
        std::array<TangentFace, 4>
            tangent_faces{};  ///< faces that it touches without a contact force; more are ignored
        std::size_t tangent_count = 0;
        bool given = true;  ///< whether its position or velocity came from outside, rounded to double
        FeatureIndex left = nothing;  ///< the contact that has just ended
        Cells::Index cell = 0;
        std::vector<PartIndex> inside;   ///< sensors, and gates that let it through
        std::vector<PartIndex> blocked;  ///< gates within a radius that do not let it through
        bool reported_lost = false, gone = false;

        std::uint32_t changes = 0;  ///< of its path
        std::uint32_t predictions = 0;
        Next next = Next::nothing;
        R next_time = infinity<R>();
        std::uint32_t next_index = 0;     ///< feature, ball, side of the cell or part, by `next`
        std::uint32_t other_version = 0;  ///< the other ball's when this was predicted
        R series_since{};                 ///< start of the present series of events in a short time
        int series_events = 0;
        Beginning begins;         ///< of its next path; kept for certificates only
        R slow_contacts_since{};  ///< start of the present series of slow contacts with balls
        int slow_contacts = 0;

        std::uint32_t heap = 0;      ///< number of its heap; 0 for none
        R heap_searched_at{-1};      ///< time of the last search without a result
        R no_equilibrium_since{-1};  ///< time since which no equilibrium was found
        std::string no_equilibrium;
    };
    /// Balls at rest in contact with each other.
    struct Heap {
        std::vector<BallIndex> balls;  ///< sorted; supports refer to indices here
        std::vector<Support> supports;
        std::vector<FeatureIndex> features;  ///< of each support; nothing between two balls
        std::size_t noted = 0;               ///< its index in the certificate
    };
    struct PartNow {
        Turning<R> turning;
        bool moves = false, open = false, down = false;
        std::vector<Region<R>> regions;  ///< of sensors and gates
        FeatureIndex first = 0, last = 0;
    };
    struct Entry {
        R time;
        BallIndex particle;
        std::uint32_t prediction;
        /// At one instant: first events without a second ball, then by the lower number, then by the higher.
        std::uint64_t order;
        friend bool operator<(const Entry& a, const Entry& b) {  // the earliest on top of the heap
            return a.time != b.time ? a.time > b.time : a.order > b.order;
        }
    };
    struct Touching {
        FeatureIndex feature;
        RestingContact<R> contact;
        R friction;
    };

    // The whole (simulation.cpp).
    void rebuild_cells();
    void join(const Ball& ball);
    void begin_inside(Particle& particle);
    void set_motion(PartIndex part);
    void change_motions();
    [[nodiscard]] R next_stop() const;
    void handle_stops();
    void reset_time_origin();
    [[nodiscard]] std::optional<BallIndex> find(BallNumber number) const;
    [[nodiscard]] const Feature<R>& shape(FeatureIndex f) const {
        return parts_[features_[f].part].turning.rate != 0 ? features_[f] : posed_[f];
    }
    [[nodiscard]] const Turning<R>* turning(PartIndex part) const {
        return parts_[part].turning.rate != 0 ? &parts_[part].turning : nullptr;
    }
    [[nodiscard]] View<R> view(const Particle& particle, PartIndex part) const {
        return {particle.path, parts_[part].moves ? &parts_[part].turning : nullptr};
    }
    /// Whether the part lets the ball through now.
    [[nodiscard]] bool ignores(PartIndex part, const Particle& particle) const;
    /// On the table's clock, s.
    [[nodiscard]] double clock(const R& time) const { return time_ + static_cast<double>(time - run_start_); }
    [[nodiscard]] std::string at_time(const R& time) const;
    [[nodiscard]] const Mixed& mixed(std::uint32_t a, std::uint32_t b) const {
        return mixed_[a * scene_->materials.size() + b];
    }

    // After changes (refresh.cpp).
    void restart_path(BallIndex i);
    void refresh(BallIndex i);
    void refresh_all();
    void refresh_beside(PartIndex part);
    void test_heap_again(std::uint32_t id);
    void test_heaps_on(PartIndex part);
    void release(PartIndex part);

    // Gates (gates.cpp).
    bool settle_gates();
    [[nodiscard]] bool passes(PartIndex part, const Particle& particle) const;
    [[nodiscard]] bool reach_gate(BallIndex i, PartIndex part);
    void leave_gate(Particle& particle, PartIndex part);
    [[nodiscard]] R gate_reach(const Particle& particle) const;

    // Predictions (predict.cpp).
    void predict(BallIndex i);
    void predict_features(Particle& particle);
    [[nodiscard]] bool slides_to(const Particle& particle, FeatureIndex f) const;
    [[nodiscard]] bool is_below_tangent_face(const Particle& particle, FeatureIndex f) const;
    void predict_sensors(Particle& particle);
    void predict_balls(BallIndex i);
    /// Result of the search `find` for a ball. Throws Refusal if the search does not end.
    R search(const Particle& particle, Other other, auto&& find) const {
        try {
            return find();
        } catch (const EndlessSearch&) {
            refuse_search("reference", particle.ball.number, other, clock(now_), *scene_);
        }
    }
    R search_border(const Particle& particle, const char* border, const Box& box, int& side) const;
    void offer(Particle& particle, const R& time, Next next, std::uint32_t index = 0,
               std::uint32_t changes = 0);

    // Paths (paths.cpp).
    void start_path(BallIndex i);
    [[nodiscard]] static bool in_touch(const R& gap, const R& radius) {
        return gap <= heap_gap * radius && gap >= -heap_overlap * radius;
    }
    void find_path(Particle& particle);
    bool move_out_of_parts(BallIndex i);
    bool correct_overlap(BallIndex i);
    void refuse_inside(const Particle& particle) const;
    void find_touching(Particle& particle);
    void note_tangent_faces(Particle& particle);
    bool rest_on_one(Particle& particle);
    bool rest_on_two(Particle& particle, const R& least);
    [[nodiscard]] Closest<R> closest(FeatureIndex f, const V<R>& position, const R& radius) const;

    // Static heaps (heaps.cpp).
    [[nodiscard]] Body<R> body_now(const Particle& particle) const;
    [[nodiscard]] bool is_at_rest(const Particle& particle) const;
    [[nodiscard]] std::vector<BallIndex> touched_at_rest(BallIndex i) const;
    [[nodiscard]] bool rests_on_ball(BallIndex i) const;
    [[nodiscard]] Heap connected_balls_at_rest(BallIndex i) const;
    void part_supports(Heap& heap, std::uint32_t k) const;
    bool find_heap(BallIndex i);
    void settle(Heap heap);
    std::vector<BallIndex> end_heap(std::uint32_t id);
    [[noreturn]] void refuse_impact_on_heap(const Particle& hit, const std::string& by) const;

    // Events (events.cpp).
    void handle(BallIndex i);
    void advance(Particle& particle);
    void refuse_endless(Particle& particle);
    void require_speed(const Particle& particle, Other other) const;
    void hit_feature(BallIndex i);
    void hit_ball(BallIndex i);
    void refuse_resting_contact(Particle& a, Particle& b) const;
    void enter_cell(BallIndex i, Cells::Index cell);
    void cross_cell(BallIndex i);
    void sense(BallIndex i);
    void lose(BallIndex i);

    // Certificates (certify.cpp).
    [[nodiscard]] R isolated_within(const Particle& particle, const R& digit, const R& margin) const;
    void note_impact(BallIndex i);
    void note_leg(Particle& particle, bool given);
    void note_motion(PartIndex part);
    void note_target(PartIndex part);
    void note_input(std::optional<BallNumber> ball, Vec2 velocity);
    void note_moved(Particle& particle);
    void note_passage(const Particle& particle, PartIndex gate, bool begins);
    void note_pair_of_parts(Particle& particle, double start);
    void note_rest(Heap& heap);
    void note_rest_ends(const Heap& heap);

    // Traces (trace.cpp).
    [[nodiscard]] static std::string_view name_of_next(const Particle& particle);
    void trace_next(TraceItem& item, const Particle& particle) const;
    void trace_paths();
    void trace_event(BallIndex i);

    // Results for callers (read_out.cpp).
    void part_contacts(const Particle& particle, std::vector<Contact>& contacts) const;
    void report(EventKind kind, const Particle& particle, Other other, const Impact<R>& impact,
                const V<R>& point, const V<R>& normal);

    std::shared_ptr<const Scene> scene_;
    std::vector<Primitive> primitives_;
    ExternalForces<R> external_;
    std::vector<Feature<R>> features_;  ///< in the pose of the scene file
    std::vector<Feature<R>> posed_;     ///< of static parts, in their pose
    std::vector<PartNow> parts_;
    std::vector<Mixed> mixed_;  ///< by two materials
    Cells cells_;

    std::vector<Particle> particles_;  ///< sorted by number; those of lost balls stay
    std::map<std::uint32_t, Heap> heaps_;
    std::uint32_t last_heap_ = 0;
    std::vector<BallNumber> reported_lost_;
    bool raised_[2] = {false, false}, rotating_ = false;
    R now_{}, run_start_{}, run_end_{};
    double time_ = 0;    ///< of the table when the run began
    double length_ = 0;  ///< of the current run, s; 0 if there is none
    std::vector<Entry> queue_;
    std::vector<Touching> touching_;
    std::vector<Event> events_;
    Counts counts_;
    Trace* trace_ = nullptr;
    Certificate* certificate_ = nullptr;
    R since_certificate_{};  ///< from its beginning to where times are counted from, s
};

}  // namespace flipside::reference

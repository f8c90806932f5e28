#pragma once
/// The trace of a step of the simple solver: its stages in the order in which they run, with what each saw
/// and did. In one collision iteration narrow phase and response take turns, pair by pair; they are written
/// as two stages, and `turn` says which narrow test a response answers.

#include "custom/flight.hpp"
#include "custom/layout.hpp"
#include "custom/response.hpp"
#include "world/trace.hpp"

namespace flipside::custom {

class SimpleTrace {
  public:
    /// Keeps references to all of them.
    SimpleTrace(Trace& trace, const Scene& scene, const Layout& layout, BroadPhase& broad);
    SimpleTrace(const SimpleTrace&) = delete;
    SimpleTrace& operator=(const SimpleTrace&) = delete;
    ~SimpleTrace() { broad_.log_tests(nullptr); }

    /// Stages that follow are of motion iteration `k` of `n`.
    void motion(int k, int n);
    void will_move(std::span<const Ball> balls) { before_.assign(balls.begin(), balls.end()); }
    void moved(std::span<const Ball> balls, const TimeInterval& interval);
    /// `moving` and `balls` as they were given to the broad phase; `tests` it counted.
    void found_pairs(std::span<const Proxy> moving, std::span<const Ball> balls, std::uint64_t tests);
    void decided_gates(const Table& table);

    /// Collision iteration `k` of `n` at most.
    void begin_round(int k, int n);
    void passed_over(const Ball& ball, PrimitiveIndex primitive);
    void tested(const Ball& ball, PrimitiveIndex primitive, const Pose& pose, const Touch& found);
    void tested(const Ball& lower, const Ball& upper, const Touch& found);
    /// After the response to the pair tested last.
    void responded(const Ball& ball, PrimitiveIndex primitive, Vec2 surface_velocity, const Impact& impact,
                   const Mixed& material);
    void responded(const Ball& lower, const Ball& upper, const Impact& impact, const Mixed& material);
    void end_round();

    void begin_sensors();
    void sensed(const Ball& ball, PrimitiveIndex primitive, double separation);

  private:
    void begin(std::string_view name, std::string_view function);
    [[nodiscard]] TraceStage& stage() { return trace_.stages.back(); }
    [[nodiscard]] TraceStage& narrow() { return trace_.stages[trace_.stages.size() - 2]; }
    void add_cells(std::span<const Cell> tree, std::size_t moving, std::span<const Ball> balls);
    void add_axes(const Ball& ball, PrimitiveIndex primitive, const Pose& pose);
    TraceItem& add_response(const Ball& before, const Ball& after, const Impact& impact,
                            const Mixed& material, double closing);
    void name_proxy(TraceItem& item, std::string_view prefix, Handle handle,
                    std::span<const Ball> balls) const;

    Trace& trace_;
    const Scene& scene_;
    const Layout& layout_;
    BroadPhase& broad_;
    std::string of_motion_, of_round_;  ///< "Motion iteration k of n. ", or nothing where there is one
    std::vector<Ball> before_;
    std::vector<PairTest> log_;
    Ball lower_, upper_;  ///< of the pair tested last
    std::int64_t turn_ = 0;
    int overlapping_ = 0, impacts_ = 0, resting_ = 0;
};

}  // namespace flipside::custom

#pragma once
/// The trace of a step of the simple solver: its stages in order, with their inputs and results. In one
/// collision iteration, narrow phase and response alternate pair by pair; the trace writes them as two
/// stages, and `turn` gives the number of the narrow-phase test to which a response belongs.

#include "custom/layout.hpp"
#include "custom/response.hpp"
#include "world/trace.hpp"

namespace flipside::custom {

class SimpleTrace {
  public:
    /// Keeps references to all arguments.
    SimpleTrace(Trace& trace, const Table& table, const std::vector<Ball>& balls, const Layout& layout,
                BroadPhase& broad);
    SimpleTrace(const SimpleTrace&) = delete;
    SimpleTrace& operator=(const SimpleTrace&) = delete;
    ~SimpleTrace() { broad_.log_searches(nullptr); }

    /// The next stages belong to motion iteration `k` of `n`, before which no ball has moved.
    void begin_motion(int k, int n);
    void moved(double seconds);
    /// `moving`: the input of the broad phase.
    void found_pairs(std::span<const Proxy> moving);
    void decided_gates();

    /// Collision iteration `k` of `n` at most.
    void begin_round(int k, int n);
    void passed_over(const Ball& ball, PrimitiveIndex primitive);
    void tested(const Ball& ball, PrimitiveIndex primitive, const Pose& pose, const Touch& found);
    void tested(const Ball& lower, const Ball& upper, const Touch& found);
    /// The response to the pair of the last test.
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
    void add_cells(std::span<const Cell> cells);
    void finish_test(TraceItem& item, const Touch& found, bool overlaps);
    TraceItem& add_response(const Ball& ball, const Impact& impact, const Mixed& material, double closing);
    static TraceItem& add_change(TraceItem& item, const std::string& prefix, const Ball& before,
                                 const Ball& after);
    /// Adds the ball, or the part and primitive, under names that begin with `prefix`.
    TraceItem& name_proxy(TraceItem& item, const std::string& prefix, Handle handle) const;

    Trace& trace_;
    const Table& table_;
    const Scene& scene_;
    const std::vector<Ball>& balls_;
    const Layout& layout_;
    BroadPhase& broad_;
    std::string of_motion_, of_round_;  ///< "Motion iteration k of n. ", or empty if n is 1
    std::vector<Ball> before_;          ///< before they moved
    std::uint64_t tests_before_ = 0;    ///< of the broad phase
    SearchLog log_;
    Ball lower_, upper_;      ///< of the last test, before the response
    std::uint64_t turn_ = 0;  ///< tests of this round
    std::uint64_t overlapping_ = 0, impacts_ = 0, resting_ = 0;
};

}  // namespace flipside::custom

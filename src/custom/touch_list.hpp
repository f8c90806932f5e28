#pragma once
/// Which balls touch what at an instant. It follows from the state of a world alone, so a world continued
/// from a saved state knows the same touches as one that ran through.

#include "custom/layout.hpp"
#include "custom/tolerances.hpp"
#include "world/events.hpp"

namespace flipside::custom {

/// A ball inside a sensor.
struct Sensed {
    BallNumber ball = 0;
    PartIndex sensor = 0;
    friend auto operator<=>(const Sensed&, const Sensed&) = default;
};

class TouchList {
  public:
    /// Finds all touches now.
    void search(const Layout& layout, const Table& table, std::span<const Ball> balls, BroadPhase& broad);
    /// The same where the pairs of awake balls whose boxes overlap are known. What sleeps beside what stands
    /// still touches what it touched before.
    void refresh(const Layout& layout, const Table& table, std::span<const Ball> balls,
                 std::span<const Pair> pairs);
    /// One per touching pair (the deepest where there are several), by ball, then other.
    [[nodiscard]] std::span<const Contact> contacts() const { return now_; }
    /// Candidates of the last search, for those who want to see them.
    [[nodiscard]] std::span<const Pair> pairs() const { return pairs_; }
    /// Shapes tested in the last search.
    [[nodiscard]] std::uint64_t narrow_tests() const { return narrow_tests_; }
    /// Reports what began and ended between the last two searches. `crossed` are the sensors that balls met
    /// in between (used up as scratch).
    void report_touches(double time, std::vector<Event>& events) const;
    void report_sensors(double time, std::vector<Sensed>& crossed, std::vector<Event>& events) const;

    /// Wakes the sleeping balls that lost a support between the last two searches, and all that they touch
    /// through sleeping balls: what was in equilibrium with that support may not be without it. A support is
    /// any contact but one from above.
    /// Cost: where one was lost, contacts · log(balls) for each pass through a chain of touching balls.
    void wake_unsupported(std::span<Ball> balls, Vec2 gravity);

    /// Makes room for so many primitives and balls.
    void reserve(std::size_t primitives, std::size_t balls);

  private:
    void begin();
    void test_pairs(const Layout& layout, const Table& table, std::span<const Ball> balls);
    void keep_sleepers(std::span<const Ball> balls);
    void test(const Layout& layout, const Table& table, const Ball& ball, PrimitiveIndex index);
    void test(const Ball& lower, const Ball& ball);

    std::vector<Contact> before_, now_;
    std::vector<Sensed> sensed_before_, sensed_;
    std::vector<Proxy> moving_;
    std::vector<Pair> pairs_;  ///< candidates
    std::vector<char> woken_;  ///< per ball: by wake_unsupported()
    std::uint64_t narrow_tests_ = 0;
};

}  // namespace flipside::custom

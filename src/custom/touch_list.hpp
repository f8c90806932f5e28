#pragma once
/// Which balls touch what at an instant. It follows from the state of a world alone, so a world continued
/// from a saved state knows the same touches as one that ran through.

#include "custom/broad_phase/near_list.hpp"
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
    /// Finds all touches now. What sleeps beside what stands still is taken over from the last time,
    /// unless `everything` says to look again.
    void refresh(const Layout& layout, const Table& table, std::span<const Ball> balls, BroadPhase& broad,
                 NearList& near, bool everything);
    /// The same from given candidates, ordered as the broad phase orders them; those with parts and those of
    /// balls in one list or in two.
    void refresh(const Layout& layout, const Table& table, std::span<const Ball> balls,
                 std::span<const Pair> candidates);
    void refresh(const Layout& layout, const Table& table, std::span<const Ball> balls,
                 std::span<const Pair> with_parts, std::span<const Pair> of_balls);
    /// Nothing touches, and nothing did.
    void clear();
    /// One per touching pair (the deepest where there are several), by ball, then other.
    [[nodiscard]] std::span<const Contact> contacts() const { return now_; }
    /// Candidates of the last search, for those who want to see them.
    [[nodiscard]] std::span<const Pair> part_pairs() const { return part_pairs_; }
    [[nodiscard]] std::span<const Pair> ball_pairs() const { return ball_pairs_; }
    /// Shapes tested in the last search.
    [[nodiscard]] std::uint64_t narrow_tests() const { return narrow_tests_; }
    /// Reports what began and ended between the last two searches. `crossed` are the sensors that balls met
    /// in between (used up as scratch).
    void report_touches(double time, std::vector<Event>& events) const;
    void report_sensors(double time, std::vector<Sensed>& crossed, std::vector<Event>& events) const;

    /// Wakes sleepers that lost a touch from below between the last two searches. Whether there were any.
    bool wake_unsupported(std::span<Ball> balls, Vec2 gravity) const;

    /// Makes room for so many pieces and balls.
    void reserve(std::size_t pieces, std::size_t balls);

  private:
    void begin();
    void tell_apart(std::span<const Pair> candidates, Handle first_ball);
    void look_at(const Layout& layout, const Table& table, std::span<const Ball> balls);
    void keep_sleepers(std::span<const Ball> balls);
    void look(const Layout& layout, const Table& table, const Ball& ball, PieceIndex index);
    void look(const Ball& lower, const Ball& ball);

    std::vector<Contact> before_, now_;
    std::vector<Sensed> sensed_before_, sensed_;
    std::vector<Proxy> moving_;
    std::vector<Pair> part_pairs_, ball_pairs_;  ///< candidates
    std::vector<Pair> near_;                     ///< scratch
    std::uint64_t narrow_tests_ = 0;
};

}  // namespace flipside::custom

#pragma once
/// The contacts of all balls at an instant. They follow from the state of a world alone, so a world that
/// continues from a saved state has the same contacts.

#include "custom/layout.hpp"
#include "custom/tolerances.hpp"
#include "world/events.hpp"

namespace flipside::custom {

class TouchList {
  public:
    /// Surfaces closer than `distance`, in radii of the smaller ball, are in contact. Keeps the references.
    TouchList(const Layout& layout, const Table& table, BroadPhase& broad, double distance)
        : layout_(layout), table_(table), broad_(broad), distance_(distance) {}

    /// Finds all contacts.
    void search(std::span<const Ball> balls);
    /// The same from known pairs of overlapping boxes with an awake ball. Contacts of sleeping balls with
    /// each other and with still parts are kept.
    void refresh(std::span<const Ball> balls, std::span<const Pair> pairs);
    /// One contact per touching pair (the deepest if there are several), sorted by ball, then other.
    [[nodiscard]] std::span<const Contact> contacts() const { return now_; }
    /// The candidate pairs of the last search, each tested by the narrow phase.
    [[nodiscard]] std::span<const Pair> pairs() const { return pairs_; }
    /// Reports the contacts that began or ended between the last two searches.
    void report_touches(std::vector<Event>& events) const;
    /// The same for overlaps with sensors. `crossed`: those in between (used as a buffer).
    void report_sensors(std::vector<Sensed>& crossed, std::vector<Event>& events) const;

    /// Forgets in which sensors a ball is: one that has just been added enters them in the next step.
    void leave_sensors(BallNumber ball);

    /// Wakes the sleeping balls that lost a support between the last two searches, and all that they touch
    /// through sleeping balls: what was in equilibrium with that support may not be without it. A support is
    /// any contact but one from above. Returns whether any woke.
    /// Cost: where one was lost, contacts · log(balls) for each pass through a chain of touching balls.
    bool wake_unsupported(std::span<Ball> balls);
    /// Wakes the sleeping balls that nothing holds by the contacts of the last search: no contacts that can
    /// push upwards, by the normal force or with friction, lead from a part or an awake ball to them, through
    /// sleeping balls. Only a state that was edited has such balls, and no contact that ends would ever wake
    /// them. Cost: as above.
    void wake_unheld(std::span<Ball> balls) const;

    void reserve(std::size_t balls);

  private:
    void begin();
    void test_pairs(std::span<const Ball> balls);
    void keep_sleeping(std::span<const Ball> balls);
    void test(const Ball& ball, PrimitiveIndex index);
    void test(const Ball& lower, const Ball& ball);

    const Layout& layout_;
    const Table& table_;
    BroadPhase& broad_;
    double distance_;
    std::vector<Contact> before_, now_;
    std::vector<Sensed> sensed_before_, sensed_;
    std::vector<Proxy> moving_;
    std::vector<Pair> pairs_;  ///< candidates
    std::vector<char> woken_;  ///< per ball: by wake_unsupported()
};

}  // namespace flipside::custom

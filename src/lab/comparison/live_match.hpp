#pragma once
/// Finds, while two runs go on, the parting that match_impacts finds when they are over.

#include <deque>
#include <map>
#include <optional>
#include <span>

#include "lab/comparison/parting.hpp"

namespace flipside::lab {

class LiveMatch {
  public:
    /// The events of a step of each run, both of which ended at `time`; `tolerance` as in match_impacts, s.
    /// Cost: impacts and balls that ever had one, times log of the balls.
    void observe(std::span<const Event> first, std::span<const Event> second, double tolerance, double time);

    /// The earliest over all balls so far. Where one run had no impact to match another's within the
    /// tolerance, that run's event is left out, though one may follow later.
    [[nodiscard]] const std::optional<Parting>& parting() const { return parting_; }

  private:
    /// The impacts of one ball that have not met their match yet: those of one run at most.
    struct Waiting {
        std::deque<Event> first, second;
        std::size_t index = 0;  ///< of the next impact to match
        bool parted = false;
    };

    void match(BallNumber ball, Waiting& waiting, double tolerance, double time);

    std::map<BallNumber, Waiting> balls_;
    std::optional<Parting> parting_;
};

}  // namespace flipside::lab

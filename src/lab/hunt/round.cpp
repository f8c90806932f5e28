#include "lab/hunt/round.hpp"

#include <algorithm>

#include "lab/hunt/mutate.hpp"
#include "lab/process/failure.hpp"

namespace flipside::lab::hunt {

namespace {

struct Candidate {
    Written written;
    Measured measured;
};

/// The worst scenes so far, the worst first.
class Worst {
  public:
    /// A (µ + λ) strategy: scenes are lists of unlike things, for which no gradient or simplex is of use.
    static constexpr std::size_t kept = 6;

    void offer(Candidate candidate) {
        const auto at = std::ranges::find_if(
            list_, [&](const Candidate& one) { return one.measured.value < candidate.measured.value; });
        list_.insert(at, std::move(candidate));
        if (list_.size() > kept) list_.pop_back();
    }
    [[nodiscard]] const std::vector<Candidate>& list() const { return list_; }

  private:
    std::vector<Candidate> list_;
};

}  // namespace

Measured measure(const Request& request, const Scene& scene) {
    return measure(request.goal, contender_for(request.contender, scene, request.dt), scene, request.seconds);
}

Found hunt_round(const Request& request, std::size_t round, const std::function<void(double)>& watch) {
    RandomScene random(request.seed * 1'000'003 + round);
    Worst worst;
    for (std::size_t i = 0; i < request.scenes; ++i) {
        watch(static_cast<double>(i) / static_cast<double>(request.scenes));
        const bool climbs = 2 * i >= request.scenes && !worst.list().empty();
        const auto parent = [&]() -> const Scene& {
            return worst
                .list()[static_cast<std::size_t>(random.whole(0, static_cast<int>(worst.list().size()) - 1))]
                .written.scene;
        };
        auto next = written(climbs ? neighbour_of(parent(), random) : random.make());
        if (!next) continue;
        Measured measured = measure(request, next->scene);
        worst.offer({std::move(*next), std::move(measured)});
    }
    if (worst.list().empty()) throw Failure("hunt: none of the scenes was valid; allowed are more of them");
    const Candidate& first = worst.list().front();
    const Found found{first.written.text, first.measured, first.written.scene.balls.size(),
                      first.written.scene.parts.size()};
    return shrunk(request, found, [&] { watch(1); });
}

}  // namespace flipside::lab::hunt

#include "lab/regimes/measure.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "lab/session/run.hpp"
#include "lab/sweep/windows.hpp"
#include "world/input_error.hpp"
#include "world/refusal.hpp"

namespace flipside::lab::regimes {

namespace {

int steps_in(double seconds) {
    return static_cast<int>(std::lround(seconds / dt));
}

/// Runs `act`; returns "" or why it cannot. An engine's own failures are no failures of the measurement.
template <class Act>
std::string attempt(Act act) {
    try {
        act();
    } catch (const Refusal& refusal) {
        return refusal.what();
    } catch (const InputError& error) {
        return error.what();
    } catch (const NotANumber& failure) {
        return failure.what();
    }
    return "";
}

/// A kind on its way through a course.
struct Runner {
    std::vector<Contender> contenders;  ///< one per scene
    std::string failure;
};

/// What one repeat brought of one kind in one regime, over all scenes.
struct Sum {
    double seconds = 0, own = 0, first_energy = 0;
    std::uint64_t ball_steps = 0;
    std::vector<std::size_t> first_balls;  ///< of each scene
};

class CourseRun {
  public:
    CourseRun(const Course& course, std::span<const Kind> kinds, const Measuring& how)
        : course_(course), kinds_(kinds), how_(how), scenes_(course.scenes()) {
        for (const Regime& regime : course.regimes)
            for (const Kind& kind : kinds)
                results_.push_back(
                    {regime.name, course.balls, regime.is_kind, kind, "", {}, 0, {}, 0, {}, 0});
        for (const Regime& regime : course.regimes)
            end_ = std::max(end_, steps_in(regime.from + regime.seconds));
    }

    std::vector<Result> take() {
        for (int repeat = 0; repeat < how_.repeats; ++repeat) {
            sums_.assign(results_.size(), {});
            run(repeat);
            for (std::size_t k = 0; k < results_.size(); ++k) note_cost(results_[k], sums_[k]);
        }
        return std::move(results_);
    }

  private:
    [[nodiscard]] std::size_t index(std::size_t regime, std::size_t kind) const {
        return regime * kinds_.size() + kind;
    }

    static void note_cost(Result& result, const Sum& sum) {
        if (result.failure.empty() && sum.ball_steps == 0) result.failure = "no ball is left";
        if (!result.failure.empty()) return;
        const double each = 1e9 / static_cast<double>(sum.ball_steps);
        result.own = result.nanoseconds.empty() ? each * sum.own : std::min(result.own, each * sum.own);
        result.nanoseconds.push_back(each * sum.seconds);
    }

    void fail(std::size_t kind, const std::string& why) {
        for (std::size_t r = 0; r < course_.regimes.size(); ++r)
            if (results_[index(r, kind)].failure.empty()) results_[index(r, kind)].failure = why;
    }

    void run(int repeat) {
        std::vector<Runner> runners(kinds_.size());
        std::vector<std::size_t> order(kinds_.size());
        for (std::size_t k = 0; k < kinds_.size(); ++k) {
            order[k] = k;
            runners[k].failure = attempt([&] {
                for (const auto& scene : scenes_) runners[k].contenders.emplace_back(kinds_[k], scene);
            });
            if (!runners[k].failure.empty()) fail(k, runners[k].failure);
        }
        // Caches and branch predictors suit best whoever runs code like that of the one before.
        std::mt19937 random(static_cast<unsigned>(repeat));
        for (int at = 0; at < end_; at += slice_steps) {
            if (how_.watch) how_.watch((repeat + at / static_cast<double>(end_)) / how_.repeats * 0.99);
            for (std::size_t r = 0; r < course_.regimes.size(); ++r)
                if (steps_in(course_.regimes[r].from) == at)
                    begin(r, runners, repeat == 0 && how_.with_errors);
            std::ranges::shuffle(order, random);
            for (const std::size_t k : order)
                if (runners[k].failure.empty()) run_slice(k, runners[k], at);
        }
    }

    void begin(std::size_t regime, std::vector<Runner>& runners, bool with_errors) {
        for (std::size_t k = 0; k < kinds_.size(); ++k) {
            if (!runners[k].failure.empty()) continue;
            Sum& sum = sums_[index(regime, k)];
            for (const Contender& contender : runners[k].contenders) {
                sum.first_energy += contender.energy();
                sum.first_balls.push_back(contender.balls());
            }
        }
        if (with_errors) note_errors(regime, runners);
    }

    void run_slice(std::size_t kind, Runner& runner, int at) {
        const int steps = std::min(slice_steps, end_ - at);
        std::vector<Slice> slices;
        runner.failure = attempt([&] {
            for (Contender& contender : runner.contenders) slices.push_back(contender.run(steps));
        });
        if (!runner.failure.empty()) return fail(kind, runner.failure);
        for (std::size_t r = 0; r < course_.regimes.size(); ++r) {
            const Regime& regime = course_.regimes[r];
            const int until = steps_in(regime.from + regime.seconds);
            if (at < steps_in(regime.from) || at >= until) continue;
            Sum& sum = sums_[index(r, kind)];
            Result& result = results_[index(r, kind)];
            for (const Slice& slice : slices) {
                sum.seconds += slice.seconds, sum.own += slice.own, sum.ball_steps += slice.ball_steps;
                result.deepest = std::max(result.deepest, slice.deepest);
            }
            if (at + steps == until) finish(r, kind, runner.contenders);
        }
    }

    void finish(std::size_t regime, std::size_t kind, std::span<const Contender> contenders) {
        const Sum& sum = sums_[index(regime, kind)];
        Result& result = results_[index(regime, kind)];
        double energy = 0;
        for (std::size_t i = 0; i < contenders.size(); ++i) {
            result.lost = std::max(result.lost, sum.first_balls[i] - contenders[i].balls());
            energy += contenders[i].energy();
        }
        if (course_.keeps_energy && energy != 0) result.drift = energy / sum.first_energy - 1;
    }

    /// All from the state of the first scene that the first engine is in.
    void note_errors(std::size_t regime, std::vector<Runner>& runners) {
        const auto leader = std::ranges::find_if(
            runners, [](Runner& r) { return r.failure.empty() && r.contenders.front().world() != nullptr; });
        if (leader == runners.end()) return;
        const std::shared_ptr<const Scene>& scene = scenes_.front();
        State state = leader->contenders.front().world()->save();
        state.origin.reset();
        const sweep::Truth truth = sweep::reference_for(*scene);
        const auto exact = truth.engine->make(scene, truth.trajectory);
        constexpr int window = 6;  // steps: a tenth of a second
        const auto go_on = [&](World& world) {
            world.restore(state);
            for (int i = 0; i < window; ++i) world.step(dt);
        };
        if (!attempt([&] { go_on(*exact); }).empty()) return;
        for (std::size_t k = 0; k < kinds_.size(); ++k) {
            if (kinds_[k].engine.empty() || !runners[k].failure.empty()) continue;
            double worst = std::numeric_limits<double>::infinity();
            attempt([&] {
                Contender one(kinds_[k], scene);
                go_on(*one.world());
                worst = distance(exact->balls(), one.world()->balls());
            });
            results_[index(regime, k)].error = worst;
        }
    }

    /// Of the worst ball, radii.
    static double distance(std::span<const Ball> a, std::span<const Ball> b) {
        if (a.size() != b.size() || a.empty()) return std::numeric_limits<double>::infinity();
        double worst = 0;
        for (std::size_t i = 0; i < a.size(); ++i)
            worst = std::max(worst, length(a[i].position - b[i].position) / a[i].radius);
        return worst;
    }

    const Course& course_;
    std::span<const Kind> kinds_;
    const Measuring& how_;
    std::vector<std::shared_ptr<const Scene>> scenes_;
    int end_ = 0;                  ///< steps
    std::vector<Result> results_;  ///< by regime, in each by kind
    std::vector<Sum> sums_;        ///< of one repeat, likewise
};

}  // namespace

std::vector<Result> measure(const Course& course, std::span<const Kind> taking_part, const Measuring& how) {
    return CourseRun(course, taking_part, how).take();
}

}  // namespace flipside::lab::regimes

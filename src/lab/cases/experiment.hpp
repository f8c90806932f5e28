#pragma once
/// What a case works with: worlds of one engine, stepped under a common limit of work, and the rows of its
/// result.

#include <limits>

#include "lab/cases/case.hpp"
#include "lab/session/run.hpp"
#include "world/input_error.hpp"
#include "world/refusal.hpp"

namespace flipside::lab {

/// A case had all the work that it may cost.
struct OutOfWork : Failure {
    using Failure::Failure;
};

/// Of a row that was not reached.
inline constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

/// A mean with the half width of its 99.9 % confidence interval.
struct Estimate {
    double mean, interval;
};
/// Of independent samples, at least two, by Student's t.
[[nodiscard]] Estimate estimate(std::span<const double> samples);

class Experiment {
  public:
    explicit Experiment(const CaseInput& input) : input_(&input) {}

    [[nodiscard]] const CaseInput& input() const { return *input_; }
    [[nodiscard]] double dt() const { return input_->dt; }
    /// The number of hits, seconds or samples: fewer in a quick run.
    template <class Number>
    [[nodiscard]] Number size(Number full, Number quick) const {
        return input_->quick ? quick : full;
    }

    /// An exact answer that event-ordered solvers must meet to `tolerance`, and time-stepping ones need not.
    void exact(std::string quantity, std::string unit, double expected, double measured, double tolerance);
    /// The same for a statistic whose confidence interval must be no wider than `needed`, so that noise
    /// cannot pass. Its tolerance is `error`, the answer's own, plus `needed`.
    void statistic(std::string quantity, std::string unit, double expected, Estimate measured, double error,
                   double needed);
    /// A quantity that every engine must meet.
    void always(std::string quantity, std::string unit, double expected, double measured,
                double tolerance = 0);
    /// A quantity that is reported without a tolerance.
    void note(std::string quantity, std::string unit, double measured, std::optional<double> expected = {});

    /// A part of the case that may end early without ending the others: what the engine refuses, and a state
    /// that is no number, and the end of the work allowed become a row named `quantity`, and their reasons
    /// the result's.
    template <class Part>
    void attempt(const std::string& quantity, Part&& part) {
        try {
            part();
        } catch (const Refusal& refusal) {
            cut_short(quantity, Verdict::refused, refusal.what());
        } catch (const InputError& error) {  // of an engine that cannot run the scene at all
            cut_short(quantity, Verdict::refused, error.what());
        } catch (const NotANumber& failure) {
            cut_short(quantity, Verdict::fail, failure.what());
        } catch (const OutOfWork& end) {
            cut_short(quantity, Verdict::not_reached, end.what());
        }
    }
    /// What has been reached goes into the table even where the work allowed was not enough for the rest.
    void cut_short() { explain(end_of_work()); }
    /// Throws std::logic_error where no row has a tolerance: such a case could not fail.
    [[nodiscard]] CaseResult finish();

  private:
    friend class Trial;

    void add(CaseRow row, bool held);
    void cut_short(const std::string& quantity, Verdict verdict, const std::string& reason);
    void explain(const std::string& reason);
    [[nodiscard]] std::string end_of_work() const;

    const CaseInput* input_;
    CaseResult result_;
    bool event_ordered_ = true;  ///< of every step so far
};

/// One world of a case, whose costs are put on the case's account.
class Trial {
  public:
    Trial(Experiment& experiment, const Scene& scene);
    /// From a state of the same scene.
    Trial(Experiment& experiment, const Scene& scene, const State& state) : Trial(experiment, scene) {
        session_.restore(state);
    }

    /// One step of the case's dt, or of `dt`. Throws OutOfWork, Refusal, and NotANumber as soon as a ball is
    /// where no number says.
    void step() { step(experiment_->dt()); }
    void step(double dt);
    /// Is another step within what the case may cost?
    [[nodiscard]] bool may_step() const;
    /// Steps until `end` exactly, and calls `see` after each step.
    template <class See>
    void run_to(double end, See&& see) {
        const Timeline timeline(time(), end - time(), experiment_->dt());
        for (std::uint64_t k = 0; k < timeline.steps(); ++k) {
            step(timeline.length(k));
            see();
        }
    }
    void run_to(double end) {
        run_to(end, [] {});
    }
    /// The same until `done` or `end`, in whole steps; was it done?
    template <class Done>
    [[nodiscard]] bool run_until(Done&& done, double end) {
        while (time() < end) {
            step();
            if (done()) return true;
        }
        return false;
    }

    [[nodiscard]] World& world() { return session_.world(); }
    [[nodiscard]] const World& world() const { return session_.world(); }
    [[nodiscard]] double time() const { return world().time(); }
    /// NaNs where it was lost.
    [[nodiscard]] Ball ball(BallNumber number) const;
    [[nodiscard]] std::span<const Event> events() const { return session_.events(); }
    /// The impacts of the last step.
    [[nodiscard]] std::vector<Event> impacts() const;
    /// The first impact from now on, until `end`.
    [[nodiscard]] std::optional<Event> first_impact(double end);
    [[nodiscard]] std::uint64_t impact_count() const { return session_.totals().impacts; }
    [[nodiscard]] std::uint64_t lost_count() const { return session_.totals().lost; }
    /// Kinetic and potential, J.
    [[nodiscard]] double energy() const { return lab::energy(world(), session_.scene()); }

  private:
    Experiment* experiment_;
    Session session_;
};

}  // namespace flipside::lab

#include "lab/cases/experiment.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>

#include <boost/math/distributions/students_t.hpp>

#include "lab/cases/double_policy.hpp"
#include "lab/cases/text.hpp"

namespace flipside::lab {

namespace {

/// What all worlds of one case may cost together. The limit of CPU time is for engines that are much slower
/// than the others at something; where it strikes, results depend on the machine, and say so.
struct Limits {
    std::uint64_t steps;
    double cpu_seconds;
};
constexpr Limits full_limits{4'000'000, 60}, quick_limits{200'000, 60};

const Limits& limits_of(const CaseInput& input) {
    return input.quick ? quick_limits : full_limits;
}

/// Whether a statistic is as certain as its row demands. What is no statistic is.
bool is_narrow(const CaseRow& row) {
    return !row.needed || (row.interval && *row.interval <= *row.needed);
}

}  // namespace

Estimate estimate(std::span<const double> samples) {
    using students_t = boost::math::students_t_distribution<double, DoublePolicy>;
    const auto n = static_cast<double>(samples.size());
    double mean = 0, squares = 0;
    for (const double sample : samples) mean += sample / n;
    for (const double sample : samples) squares += (sample - mean) * (sample - mean);
    const double quantile = boost::math::quantile(students_t(n - 1), 1 - 0.001 / 2);
    return {mean, quantile * std::sqrt(squares / (n - 1) / n)};
}

void Experiment::exact(std::string quantity, std::string unit, double expected, double measured,
                       double tolerance) {
    add({.quantity = std::move(quantity),
         .unit = std::move(unit),
         .expected = expected,
         .measured = measured,
         .tolerance = tolerance},
        event_ordered_);
}

void Experiment::statistic(std::string quantity, std::string unit, double expected, Estimate measured,
                           double error, double needed) {
    add({.quantity = std::move(quantity),
         .unit = std::move(unit),
         .expected = expected,
         .measured = measured.mean,
         .tolerance = error + needed,
         .interval = measured.interval,
         .needed = needed},
        event_ordered_);
}

void Experiment::always(std::string quantity, std::string unit, double expected, double measured,
                        double tolerance) {
    add({.quantity = std::move(quantity),
         .unit = std::move(unit),
         .expected = expected,
         .measured = measured,
         .tolerance = tolerance},
        true);
}

void Experiment::note(std::string quantity, std::string unit, double measured,
                      std::optional<double> expected) {
    add({.quantity = std::move(quantity),
         .unit = std::move(unit),
         .expected = expected,
         .measured = measured},
        false);
}

void Experiment::add(CaseRow row, bool held) {
    row.error = row.expected ? std::abs(row.measured - *row.expected) : no_number;
    if (std::isnan(row.measured))
        row.verdict = Verdict::not_reached;
    else if (held)
        row.verdict = row.error <= *row.tolerance && is_narrow(row) ? Verdict::pass : Verdict::fail;
    result_.rows.push_back(std::move(row));
}

void Experiment::cut_short(const std::string& quantity, Verdict verdict, const std::string& reason) {
    result_.rows.push_back({.quantity = quantity,
                            .measured = no_number,
                            .error = no_number,
                            .tolerance = 0,
                            .verdict = verdict});
    explain(reason);
}

void Experiment::explain(const std::string& reason) {
    if (result_.reason.find(reason) == std::string::npos)
        result_.reason += (result_.reason.empty() ? "" : "; ") + reason;
}

std::string Experiment::end_of_work() const {
    const Limits& limits = limits_of(*input_);
    return result_.steps >= limits.steps
               ? "stopped after " + std::to_string(limits.steps) + " steps, the most that a case may take"
               : "stopped after " + text_of(limits.cpu_seconds) + " s of CPU, the most that a case may cost";
}

CaseResult Experiment::finish() {
    if (std::ranges::none_of(result_.rows, [](const CaseRow& row) { return row.tolerance.has_value(); }))
        throw std::logic_error("a case must judge at least one quantity");
    const auto has = [&](Verdict verdict) {
        return std::ranges::any_of(
            result_.rows, [&](const CaseRow& row) { return row.verdict == verdict && row.tolerance; });
    };
    result_.verdict = Verdict::pass;
    for (const Verdict worst : {Verdict::fail, Verdict::refused, Verdict::not_reached, Verdict::measured}) {
        if (!has(worst)) continue;
        result_.verdict = worst;
        break;
    }
    return std::move(result_);
}

Trial::Trial(Experiment& experiment, const Scene& scene)
    : experiment_(&experiment),
      session_(std::make_shared<const Scene>(scene), *experiment.input().contender.engine,
               experiment.input().contender.settings) {}

bool Trial::may_step() const {
    const Limits& limits = limits_of(experiment_->input());
    return experiment_->result_.steps < limits.steps && experiment_->result_.cpu_seconds < limits.cpu_seconds;
}

void Trial::step(double dt) {
    CaseResult& result = experiment_->result_;
    if (!may_step()) throw OutOfWork(experiment_->end_of_work());
    const Totals before = session_.totals();
    session_.step(dt);
    check_finite(session_, time());
    ++result.steps;
    result.impacts += session_.totals().impacts - before.impacts;
    result.cpu_seconds += session_.totals().step_seconds - before.step_seconds;
    result.handed_over += world().statistics().handed_over;
    if (!session_.world().statistics().event_ordered) experiment_->event_ordered_ = false;
    if (experiment_->input().watch) experiment_->input().watch();
}

std::optional<Event> Trial::first_impact(double end) {
    std::vector<Event> found;
    while (found.empty() && time() < end) {
        step();
        found = impacts();
    }
    return found.empty() ? std::nullopt : std::optional(found.front());
}

std::vector<Event> Trial::impacts() const {
    std::vector<Event> found;
    std::ranges::copy_if(events(), std::back_inserter(found),
                         [](const Event& event) { return event.kind == EventKind::impact; });
    return found;
}

Ball Trial::ball(BallNumber number) const {
    const auto balls = world().balls();
    const auto at = std::ranges::find(balls, number, &Ball::number);
    if (at != balls.end()) return *at;
    Ball lost;
    lost.position = lost.velocity = {no_number, no_number};
    return lost;
}

}  // namespace flipside::lab

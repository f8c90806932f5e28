#include "lab/sweep/runs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "lab/files/csv.hpp"
#include "lab/files/csv_table.hpp"
#include "lab/files/text_stream.hpp"
#include "world/printable.hpp"

namespace flipside::lab::sweep {

namespace {

constexpr const char* blame_columns[] = {"fault", "kind", "met", "ball", "at", "amount"};

/// Reads the rows of one unit, and refuses numbers that its runs cannot have.
class RunReader {
  public:
    RunReader(const CsvTable& table, const Plan& plan, const Unit& unit)
        : table_(table), plan_(plan), unit_(unit) {}

    Run read(std::size_t row) {
        Run run;
        run.variant = table_.name(row, "variant");
        if (run.variant != unit_.variant->name) table_.refuse(row, "variant", "the one of this file");
        run.contender = table_.name(row, "contender");
        run.dt = table_.finite(row, "dt");
        run.window = table_.count(row, "window");
        require_order(row, run);
        run.seconds = table_.finite(row, "seconds");
        if (run.seconds < window_unit * unit_.variant->shortest ||
            run.seconds > window_unit * unit_.variant->longest)
            table_.refuse(row, "seconds", "the length of a window of this variant");
        read_outcome(row, run.outcome);
        run.blame = read_blame(row, run.outcome);
        read_times(row, run);
        return run;
    }

  private:
    /// By contender, step size and window as measure_unit() makes them, and none twice.
    void require_order(std::size_t row, const Run& run) {
        const auto contender = std::ranges::find(plan_.contenders, run.contender, &Contender::name);
        if (contender == plan_.contenders.end()) table_.refuse(row, "contender", "one of this sweep");
        const std::vector<double> steps = steps_of(**contender, plan_);
        const auto step = std::ranges::find(steps, run.dt);
        if (step == steps.end()) table_.refuse(row, "dt", "a step size of this contender");
        const std::size_t first = unit_.block * plan_.block_size;
        if (run.window < first || run.window >= first + plan_.block_size)
            table_.refuse(row, "window", "the number of a window of this file");
        const Place place{contender - plan_.contenders.begin(), step - steps.begin(), run.window};
        if (row > 0 && place <= last_) table_.refuse(row, "window", "in order: a row is twice or misplaced");
        last_ = place;
    }
    void read_outcome(std::size_t row, Outcome& outcome) const {
        outcome.failure = table_.one_of(row, "failure", failures);
        outcome.error = error(row, "error", outcome.failure);
        outcome.typical = error(row, "typical", outcome.failure);
        if (outcome.typical > outcome.error) table_.refuse(row, "typical", "at most the largest error");
        outcome.impacts = impacts(row, "impacts");
        outcome.missed = impacts(row, "missed");
        if (outcome.missed > outcome.impacts) table_.refuse(row, "missed", "at most the number of impacts");
        outcome.spurious = impacts(row, "spurious");
    }
    double error(std::size_t row, const char* column, const std::string& failure) const {
        const double value = table_.number(row, column);
        const bool is_right = failure.empty() ? std::isfinite(value) && value >= 0 : value == INFINITY;
        if (!is_right) table_.refuse(row, column, "the error of such a run");
        return value;
    }
    /// Sums over all runs of a sweep must fit.
    std::size_t impacts(std::size_t row, const char* column) const {
        constexpr std::uint64_t most = 1'000'000'000'000;
        const std::uint64_t value = table_.count(row, column);
        if (value > most) table_.refuse(row, column, "a number of impacts");
        return value;
    }
    std::optional<Charge> read_blame(std::size_t row, const Outcome& outcome) const {
        if (!diverged(outcome)) {
            for (const char* column : blame_columns)
                if (!table_.text(row, column).empty())
                    table_.refuse(row, column, "empty, as that of a run that is exact");
            return std::nullopt;
        }
        Charge charge;
        const std::string& fault = table_.one_of(row, "fault", fault_names);
        charge.fault = static_cast<Fault>(std::ranges::find(fault_names, fault) - fault_names);
        charge.kind = table_.one_of(row, "kind", met_kinds);
        charge.met = table_.text(row, "met");
        constexpr std::size_t longest = 255;
        if (charge.met.size() > longest || charge.met != printable(charge.met))
            table_.refuse(row, "met", "a name in print");
        const std::uint64_t ball = table_.count(row, "ball");
        if (ball > std::numeric_limits<BallNumber>::max()) table_.refuse(row, "ball", "the number of a ball");
        charge.ball = static_cast<BallNumber>(ball);
        charge.time = table_.finite(row, "at");
        charge.amount = table_.finite(row, "amount");
        if (charge.amount < 0) table_.refuse(row, "amount", "0 or above");
        return charge;
    }
    void read_times(std::size_t row, Run& run) const {
        constexpr double longest = 1e9;  // s
        run.cpu_min = table_.number(row, "cpu_min");
        run.cpu_median = table_.number(row, "cpu_median");
        if (std::isnan(run.cpu_min) && std::isnan(run.cpu_median)) return;  // not timed
        if (!(run.cpu_min >= 0 && run.cpu_min <= longest)) table_.refuse(row, "cpu_min", "a time");
        if (!(run.cpu_median >= run.cpu_min && run.cpu_median <= longest))
            table_.refuse(row, "cpu_median", "a time, and at least the least one");
    }

    using Place = std::tuple<std::ptrdiff_t, std::ptrdiff_t, std::size_t>;

    const CsvTable& table_;
    const Plan& plan_;
    const Unit& unit_;
    Place last_;
};

}  // namespace

Charge charge_of(const Blame& blame, const Scene& scene) {
    Event met;
    if (blame.other) met.other = *blame.other;
    return {blame.fault, blame.kind, blame.other ? printable(name_of_other(met, scene)) : "",
            blame.ball,  blame.time, blame.amount};
}

std::string to_csv(const std::vector<Run>& runs) {
    TextStream out;
    out << "variant,contender,dt,window,seconds,failure,error,typical,impacts,missed,spurious,fault,"
           "kind,met,ball,at,amount,cpu_min,cpu_median\n";
    CsvRow row;
    for (const Run& run : runs) {
        row.add(run.variant).add(run.contender).add(run.dt).add(run.window).add(run.seconds);
        row.add(run.outcome.failure).add(run.outcome.error).add(run.outcome.typical);
        row.add(run.outcome.impacts).add(run.outcome.missed).add(run.outcome.spurious);
        if (const auto& blame = run.blame)
            row.add(name_of(blame->fault))
                .add(blame->kind)
                .add(blame->met)
                .add(blame->ball)
                .add(blame->time)
                .add(blame->amount);
        else
            for ([[maybe_unused]] const char* column : blame_columns) row.add("");
        row.add(run.cpu_min).add(run.cpu_median).write(out);
    }
    return out.str();
}

std::vector<Run> parse_runs(const std::string& csv, const std::filesystem::path& file, const Plan& plan,
                            const Unit& unit) {
    const CsvTable table(file, csv);
    RunReader reader(table, plan, unit);
    std::vector<Run> runs;
    for (std::size_t row = 0; row < table.rows(); ++row) runs.push_back(reader.read(row));
    return runs;
}

}  // namespace flipside::lab::sweep

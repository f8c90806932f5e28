#include "lab/sweep/runs.hpp"

#include "lab/csv.hpp"
#include "lab/csv_table.hpp"
#include "lab/whole_file.hpp"

namespace flipside::lab::sweep {

void write_runs(const std::filesystem::path& file, const std::vector<Run>& runs) {
    WholeFile whole(file);
    whole.out() << "variant,entrant,dt,window,seconds,failure,error,typical,impacts,missed,spurious,cpu_min,"
                   "cpu_median\n";
    CsvRow row;
    for (const Run& run : runs) {
        row.add(run.variant).add(run.entrant).add(run.dt).add(run.window).add(run.seconds);
        row.add(run.outcome.failure).add(run.outcome.error).add(run.outcome.typical);
        row.add(run.outcome.impacts).add(run.outcome.missed).add(run.outcome.spurious);
        row.add(run.cpu_min).add(run.cpu_median).write(whole.out());
    }
    whole.finish();
}

std::vector<Run> read_runs(const std::filesystem::path& file) {
    const CsvTable table(file);
    std::vector<Run> runs(table.rows());
    for (std::size_t i = 0; i < runs.size(); ++i) {
        Run& run = runs[i];
        run.variant = table.text(i, "variant");
        run.entrant = table.text(i, "entrant");
        run.dt = table.number(i, "dt");
        run.window = table.count(i, "window");
        run.seconds = table.number(i, "seconds");
        run.outcome.failure = table.text(i, "failure");
        run.outcome.error = table.number(i, "error");
        run.outcome.typical = table.number(i, "typical");
        run.outcome.impacts = table.count(i, "impacts");
        run.outcome.missed = table.count(i, "missed");
        run.outcome.spurious = table.count(i, "spurious");
        run.cpu_min = table.number(i, "cpu_min");
        run.cpu_median = table.number(i, "cpu_median");
    }
    return runs;
}

}  // namespace flipside::lab::sweep

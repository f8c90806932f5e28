/// Run files of a sweep, without their last line (lab/files/data_file.hpp): read, written again and summed
/// up.

#include "lab/sweep/runs.hpp"

#include "fuzz/oracle.hpp"
#include "fuzz/target.hpp"
#include "lab/sweep/summary.hpp"

namespace flipside::fuzz {

void run_input(std::string_view input) {
    set_subject("reader");
    namespace sweep = lab::sweep;
    static const sweep::Plan plan = sweep::quick_plan(sweep::standard_variants(), 1);
    static const sweep::Unit unit = sweep::units_of(plan).front();
    std::vector<sweep::Run> runs;
    const bool read = accepted([&] {
        const CpuLimit limit(longest_answer);
        runs = sweep::parse_runs(std::string(input), "input.csv", plan, unit);
        static_cast<void>(sweep::summarize(runs));
    });
    if (!read) return;
    const std::string text = sweep::to_csv(runs);
    require(sweep::to_csv(sweep::parse_runs(text, "written", plan, unit)) == text,
            "runs are not read as they were written");
}

}  // namespace flipside::fuzz

#include <algorithm>
#include <cmath>
#include <limits>

#include "lab/cases/case.hpp"
#include "lab/contenders/engines.hpp"
#include "lab/files/csv.hpp"
#include "lab/files/csv_table.hpp"
#include "lab/files/text_stream.hpp"
#include "lab/report/chapter.hpp"
#include "lab/report/contender.hpp"

namespace flipside::lab::report {

namespace {

/// Cases of which one quantity tells the whole story, and whose error depends on step and solver.
struct Story {
    const char *name, *quantity, *says, *unit;
};
constexpr Story stories[] = {
    {"zeno-drop", "time of the last impact, e = 0.8", "Zeno drop: moment of the last impact", "s"},
    {"column", "worst height of 10 balls after 10 s, error",
     "Column of 10 elastic balls: worst height after 10 s", "m"},
    {"circular-billiard", "radius of the caustic", "Circular billiard: radius of the caustic", "m"},
    {"bowl", "period from 60 degrees", "Bowl: period from 60 degrees", "s"},
    {"incline", "way down in 1 s, slipping", "Incline: way of a slipping ball in 1 s", "m"}};

/// Those of the cases that the report has.
std::vector<Story> chosen_stories(const Effort& effort) {
    std::vector<Story> chosen;
    std::ranges::copy_if(stories, std::back_inserter(chosen), [&](const Story& story) {
        return effort.cases.empty() || std::ranges::find(effort.cases, story.name) != effort.cases.end();
    });
    return chosen;
}

std::string work_file(const Contender& contender) {
    return "case-steps-" + contender.name + ".csv";
}

void write_row(CsvRow& row, std::ostream& out, const Story& story, double dt, const CaseResult& result) {
    const auto at = std::ranges::find(result.rows, story.quantity, &CaseRow::quantity);
    const bool reached = at != result.rows.end() && std::isfinite(at->error);
    std::string failure;
    if (!reached) failure = result.reason.empty() ? "not reached" : result.reason;
    row.add(story.name)
        .add(dt)
        .add(reached ? at->error : std::numeric_limits<double>::infinity())
        .add(failure)
        .add(result.cpu_seconds)
        .write(out);
}

/// CSV: case,dt,error,failure,cpu_seconds.
Measurement work_measurement(const Contender& contender, const Effort& effort) {
    const auto measure = [=](const Watch& watch) {
        TextStream file;
        CsvRow row;
        row.add("case").add("dt").add("error").add("failure").add("cpu_seconds").write(file);
        double done = 0;
        const std::vector<Story> chosen = chosen_stories(effort);
        const double whole = static_cast<double>(chosen.size() * effort.case_steps.size());
        for (const Story& story : chosen) {
            const std::string name = story.name;
            const Case& which = *find_cases({&name, 1}).front();
            for (const double dt : effort.case_steps) {
                const CaseInput input{
                    {&engine_named(contender.engine), settings_of(contender, Scene{})}, dt, true, [&] {
                        watch(done / whole);
                    }};
                write_row(row, file, story, dt, run_case(which, input));
                ++done;
            }
        }
        return file.str();
    };
    return measurement_of_file(work_file(contender), 0.2 * static_cast<double>(effort.case_steps.size()),
                               measure);
}

Content show_case_work(const Data& data, const std::vector<Story>& chosen) {
    Content content;
    for (const Story& story : chosen) {
        Figure figure{
            std::string("case-") + story.name,
            story.says,
            {"CPU seconds of the experiment (" + libraries() + ")", "cpu_seconds", true},
            {std::string("error, ") + story.unit, "error", true, 1e-17},
            {},
            {},
            "One point per step size; further down is more exact, further left is cheaper. A level "
            "curve is a solver whose answer does not depend on the step: more steps only cost more."};
        for (const Contender& contender : contenders()) {
            const CsvTable table(data.path(work_file(contender)), data.read(work_file(contender)));
            Series series = series_of(contender);
            for (std::size_t row = 0; row < table.rows(); ++row) {
                if (table.text(row, "case") != story.name) continue;
                const std::string& failure = table.text(row, "failure");
                series.points.push_back(
                    {table.number(row, "cpu_seconds"), table.number(row, "error"),
                     "dt = " + step_text(table.number(row, "dt")) + (failure.empty() ? "" : "\n" + failure)});
            }
            figure.series.push_back(series);
        }
        content.figures.push_back(figure);
    }
    return content;
}

}  // namespace

Chapter case_work_chapter(const Effort& effort) {
    Chapter chapter{
        "case-work",
        "Work and precision in hard cases",
        "Some of the hard cases again, in their short form, at steps from " +
            step_text(effort.case_steps.front()) + " to " + step_text(effort.case_steps.back()) +
            ": here the right answer is known in closed form.",
        {},
        [chosen = chosen_stories(effort)](const Data& data) { return show_case_work(data, chosen); }};
    for (const Contender& contender : contenders())
        chapter.measurements.push_back(work_measurement(contender, effort));
    return chapter;
}

}  // namespace flipside::lab::report

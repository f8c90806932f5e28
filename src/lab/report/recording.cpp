#include "lab/report/recording.hpp"

#include <algorithm>
#include <limits>
#include <optional>

#include "lab/files/csv.hpp"
#include "lab/files/csv_table.hpp"
#include "lab/files/text_stream.hpp"
#include "lab/process/failure.hpp"
#include "lab/session/run.hpp"
#include "world/input_error.hpp"
#include "world/refusal.hpp"

namespace flipside::lab::report {

namespace {

constexpr std::uint64_t samples = 120;

/// Ends a run from within.
struct OverLimit {};

}  // namespace

std::string run_plan(const RunPlan& plan, const std::function<void(const Session&)>& after,
                     const Watch& watch) {
    const Timeline timeline(0, plan.seconds, plan.dt);
    // What the watch throws is no failure of the run.
    std::exception_ptr stopped;
    try {
        Session session(plan.scene, engine_named(plan.contender.engine),
                        settings_of(plan.contender, *plan.scene));
        after(session);
        const auto look = [&](const Session& at, std::uint64_t, double time) {
            after(at);
            try {
                watch(time / plan.seconds);
            } catch (...) {
                stopped = std::current_exception();
                throw;
            }
            if (at.totals().step_seconds > plan.limit) throw OverLimit{};
        };
        run({&session, 1}, timeline, {}, look);
    } catch (const OverLimit&) {
        return "given up after " + short_number(plan.limit) + " s of CPU time";
    } catch (const Refusal& refusal) {
        return refusal.what();
    } catch (const InputError& error) {  // a scene that the engine cannot run
        return error.what();
    } catch (const Failure& failure) {
        if (stopped) throw;
        return failure.what();
    }
    return "";
}

std::string record(const RunPlan& plan, const std::function<double(const Session&)>& quantity,
                   const Watch& watch) {
    TextStream csv;
    CsvRow row;
    row.add("time").add("value").add("failure").write(csv);
    const std::uint64_t steps = Timeline(0, plan.seconds, plan.dt).steps();
    const std::uint64_t every = std::max<std::uint64_t>(1, (steps + samples - 1) / samples);
    double last = 0;
    const auto after = [&](const Session& session) {
        last = session.world().time();
        if (session.totals().steps % every != 0) return;
        row.add(last).add(quantity(session)).add("").write(csv);
    };
    const std::string failure = run_plan(plan, after, watch);
    if (!failure.empty()) row.add(last).add(std::numeric_limits<double>::infinity()).add(failure).write(csv);
    return csv.str();
}

std::vector<Point> recorded(const Data& data, const std::string& file) {
    const CsvTable table(data.path(file), data.read(file));
    std::vector<Point> points;
    for (std::size_t row = 0; row < table.rows(); ++row)
        points.push_back({table.number(row, "time"), table.number(row, "value"), table.text(row, "failure")});
    return points;
}

}  // namespace flipside::lab::report

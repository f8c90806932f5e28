#pragma once
/// A folder as `flipside sweep` leaves it, with errors that are known: of order 1 for custom-simple, of
/// order 2 for box2d, of none for custom-continuous, and all runs of box2d-no-bullets failed at 1/30 s.

#include <cmath>
#include <filesystem>
#include <limits>

#include "lab/files/data_file.hpp"
#include "lab/sweep/runs.hpp"

namespace flipside::lab::report {

inline double made_up_error(const std::string& contender, double dt) {
    if (contender == "custom-continuous") return 1e-14;
    if (contender == "custom-simple") return 3 * dt;
    if (contender == "box2d-no-bullets" && dt > 1. / 50) return std::numeric_limits<double>::infinity();
    return 5 * dt * dt;
}

/// CPU seconds per simulated second.
inline double made_up_cost(double dt) {
    return 1e-5 / dt;
}

inline void make_up_sweep(const std::filesystem::path& folder) {
    const sweep::Plan plan = sweep::quick_plan(sweep::variants_of({"toy"}, 0), 1);
    std::filesystem::create_directories(folder / "runs");
    const std::string text = sweep::to_json(plan);
    sweep::write_plan(folder, text);
    std::vector<sweep::Run> runs;
    for (const char* contender : {"custom-continuous", "custom-simple", "box2d", "box2d-no-bullets"}) {
        for (const double dt : sweep::steps_of(sweep::contender_named(contender), plan)) {
            for (std::size_t window = 0; window < 3; ++window) {  // the median is the one in the middle
                sweep::Run run;
                run.variant = plan.variants.front().name, run.contender = contender;
                run.dt = dt, run.window = window, run.seconds = 3 * sweep::window_unit;
                const double error = made_up_error(contender, dt);
                run.outcome = {std::isinf(error) ? "lost ball" : "",
                               error * (0.5 + 0.5 * static_cast<double>(window)),
                               0.5 * error,
                               2,
                               0,
                               0};
                if (sweep::diverged(run.outcome))
                    run.blame = window == 0 ? sweep::Charge{Fault::drift, "none", "", 0, 1, 0.01}
                                            : sweep::Charge{Fault::late, "arc", "corner", 0, 1, 0.01};
                run.cpu_min = run.cpu_median = 0.1 * made_up_cost(dt);
                runs.push_back(run);
            }
        }
    }
    const sweep::Unit unit{&plan.variants.front(), 0};
    write_data_file(sweep::runs_file(unit, folder), sweep::origin_of_unit("runs", text, unit),
                    sweep::to_csv(runs));
}

}  // namespace flipside::lab::report

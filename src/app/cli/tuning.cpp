#include "app/cli/tuning.hpp"

#include <cmath>

#include "app/cli/output.hpp"
#include "app/cli/progress.hpp"
#include "lab/files/whole_file.hpp"
#include "world/printable.hpp"

namespace flipside::app {

namespace {

using lab::Median;
using lab::tune::Judged;
using lab::tune::Tuning;

void print_judged(const char* role, const Judged& judged, double target, const std::optional<Median>& ratio) {
    print("  %-9s %9.2e r  %9.4g ms/s", role, judged.score.error, 1e3 * judged.score.cost);
    if (ratio)
        print("  the tuned one costs %.3g times that (%.3g to %.3g)", ratio->value, ratio->low, ratio->high);
    if (!(judged.score.error <= target)) print("  misses the error asked for");
    print("\n            %s\n", printable(judged.text).c_str());
}

void print_tuning(const Tuning& tuning) {
    print("%s, error at most %g r: the best of %zu contenders\n", printable(tuning.variant).c_str(),
          tuning.target, tuning.tried);
    print_judged("tuned", tuning.tuned, tuning.target, {});
    print_judged("untuned", tuning.untuned, tuning.target, tuning.over_untuned);
    print_judged("custom", tuning.ours, tuning.target, tuning.over_ours);
    print("\n");
}

}  // namespace

int run_tuning(const lab::tune::Request& request, std::span<const lab::sweep::Variant> variants,
               const std::filesystem::path& folder) {
    lab::make_folder(folder);
    lab::WholeFile table(folder / "tuning.csv");
    std::vector<Tuning> all;
    for (const lab::sweep::Variant& variant : variants) {
        std::vector<Tuning> found;
        {
            Progress progress(static_cast<double>(request.targets.size()));
            found = lab::tune::tune(request, variant, [&](double done) { progress.at(done); });
        }
        for (Tuning& tuning : found) {
            print_tuning(tuning);
            all.push_back(std::move(tuning));
        }
    }
    lab::tune::write_csv(table.out(), all);
    table.finish();
    print(
        "Found on %zu windows, judged on as many others: position of the worst ball at the end, median of "
        "the "
        "windows, radii; CPU ms\nper simulated second, and the ratio of costs in the median window with its "
        "95 %% confidence interval.\n",
        request.windows);
    return 0;
}

}  // namespace flipside::app

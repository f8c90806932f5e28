#include <algorithm>

#include "app/cli/commands.hpp"
#include "app/cli/distinct_files.hpp"
#include "app/cli/output.hpp"
#include "app/cli/output_file.hpp"
#include "app/cli/progress.hpp"
#include "app/cli/run_options.hpp"
#include "lab/pairs/pair_tests.hpp"

namespace flipside::app {

namespace {

struct PairsOptions {
    double seconds = 60;
    std::size_t most_balls = 100'000;
    std::string json;  ///< file; "" where not asked for
};

void print_toy(const lab::PairTests& found) {
    print("Box tests per search, insertion included: balls of 42 px in 960 x 704 px, %g s at 60 Hz\n\n",
          found.seconds);
    constexpr int shown[] = {2, 4, 6, 8, 16, 24, 32};
    print("%-18s", "n =");
    for (const int n : shown) print(" %6d", n);
    print(" %8s %7s %9s %9s\n", "slope", "R2", "crossing", "quadtree");
    double quadtree = 0;
    for (const auto& row : found.rows)
        if (row.broad_phase == "quadtree") quadtree = row.tests.back();
    for (const auto& row : found.rows) {
        print("%-18s", row.broad_phase.c_str());
        for (const int n : shown)
            print(" %6.1f", row.tests[static_cast<std::size_t>(n - lab::PairTests::fewest)]);
        print(" %8.3f %7.4f", row.line.slope, row.line.r_squared);
        if (row.crossing)
            print(" %9.2f", *row.crossing);
        else
            print(" %9s", "-");
        print(" %8.2fx\n", quadtree / row.tests.back());
    }
    print(
        "\nslope, R2: of the straight line through n = 2 ... 32. crossing: where that line meets\n"
        "n(n-1)/2. quadtree: how many times fewer tests than the quadtree's at n = 32.\n");
}

void print_growth(const lab::PairTests& found) {
    print("\nGrowth, as dense as 32 balls above: box tests and CPU time (ns) per ball and search\n\n");
    print("%-9s", "balls");
    for (const auto& row : found.rows) print(" %20s", row.broad_phase.c_str());
    print("\n");
    for (const auto& growth : found.growth) {
        print("%-9zu", growth.balls);
        for (const auto& row : found.rows) {
            const auto cost =
                std::ranges::find(growth.costs, row.broad_phase, &lab::PairTests::Growth::Cost::broad_phase);
            if (cost == growth.costs.end())
                print(" %20s", "-");
            else
                print(" %11.2f %8.1f", cost->tests_per_ball, cost->ns_per_ball);
        }
        print("\n");
    }
}

int pairs(const PairsOptions& options) {
    require_distinct({{}, {{"--json", options.json}}, true});
    OutputFile json(options.json);
    const lab::PairTests found = [&] {
        Progress progress(1);
        return lab::count_pair_tests(options.seconds, options.most_balls,
                                     [&](double done) { progress.at(done); });
    }();
    if (auto* out = json.out()) *out << to_json(found);
    json.finish();
    print_toy(found);
    print_growth(found);
    return 0;
}

}  // namespace

void add_pairs(CLI::App& program, Action& chosen) {
    auto options = std::make_shared<PairsOptions>();
    CLI::App& command = *program.add_subcommand(
        "pairs", "Count box tests of every broad phase, from 2 balls to 100,000: the toy's experiment");
    command.add_option("--seconds", options->seconds, "Simulated time for each number of balls")
        ->capture_default_str()
        ->check(number_from(0.1, 3600))
        ->type_name("T");
    command.add_option("--most", options->most_balls, "Largest number of balls in the table of growth")
        ->capture_default_str()
        ->check(whole_number_from(32, 100'000))
        ->type_name("N");
    command.add_option("--json", options->json, "Everything found, as JSON")->type_name("FILE");
    command.callback([options, &chosen] { chosen = [options] { return pairs(*options); }; });
}

}  // namespace flipside::app

#include <algorithm>
#include <cmath>

#include "app/cli/commands.hpp"
#include "app/cli/distinct_files.hpp"
#include "app/cli/output.hpp"
#include "app/cli/output_file.hpp"
#include "app/cli/progress.hpp"
#include "app/cli/run_options.hpp"
#include "lab/cases/case.hpp"
#include "lab/cases/stability_map.hpp"
#include "lab/contenders/engines.hpp"
#include "lab/files/whole_file.hpp"
#include "lab/hunt/hard.hpp"
#include "world/input_error.hpp"
#include "world/printable.hpp"
#include "world/scene_file.hpp"

namespace flipside::app {

namespace {

struct CasesOptions {
    std::vector<std::string> names;  ///< empty: all cases
    std::string engine = "custom";
    std::vector<std::string> settings;
    std::string dt = "1/60";
    bool quick = false;
    bool list = false;
    bool hard = false;
    std::string json, map;  ///< files; "" where not asked for
};

std::string number(const char* format, std::optional<double> value) {
    if (!value || std::isnan(*value)) return "-";
    char text[32];
    std::snprintf(text, sizeof text, format, *value);
    return text;
}

void print_case(const lab::CaseRun& run) {
    const lab::CaseResult& result = run.result;
    print("\n%2d %s: %s  (%.3g s of CPU)\n", run.which->number, std::string(run.which->name).c_str(),
          std::string(name_of(result.verdict)).c_str(), result.cpu_seconds);
    for (const lab::SettingChange& change : run.recommended)
        print("   with %s=%s, as the case recommends\n", change.name.c_str(), change.value.c_str());
    if (!result.reason.empty()) print("   %s\n", printable(result.reason).c_str());
    if (result.handed_over > 0)
        print("   balls left to the time-stepping solver, summed over the steps: %llu\n",
              static_cast<unsigned long long>(result.handed_over));
    for (const lab::CaseRow& row : result.rows) {
        const std::string name = row.quantity + (row.unit.empty() ? "" : " [" + row.unit + "]");
        print("   %-62s %14s %14s %9s %9s  %s\n", name.c_str(), number("%.9g", row.expected).c_str(),
              number("%.9g", row.measured).c_str(), number("%.2g", row.error).c_str(),
              number("%.2g", row.tolerance).c_str(), std::string(name_of(row.verdict)).c_str());
    }
}

void print_head(const lab::CaseInput& input) {
    const Engine& engine = *input.contender.engine;
    print("Hard cases on %s%s%s, dt = %.6g s%s\n\n   %-62s %14s %14s %9s %9s  %s\n",
          std::string(engine.name).c_str(), engine.library.empty() ? "" : ", ",
          std::string(engine.library).c_str(), input.dt, input.quick ? ", quick" : "", "quantity", "expected",
          "measured", "error", "tolerance", "verdict");
}

void print_summary(std::span<const lab::CaseRun> runs) {
    print("\n%zu cases:", runs.size());
    for (const std::string_view name : lab::verdict_names) {
        const auto count = std::ranges::count(
            runs, name, [](const lab::CaseRun& run) { return name_of(run.result.verdict); });
        if (count > 0) print(" %td %s", count, std::string(name).c_str());
    }
    print("\n");
}

int list_cases() {
    for (const lab::Case& one : lab::cases())
        print("%2d %-20s %s\n", one.number, std::string(one.name).c_str(), std::string(one.about).c_str());
    return 0;
}

std::vector<lab::SettingChange> changes_of(const CasesOptions& options) {
    const Engine* const used[] = {&lab::engine_named(options.engine)};
    return lab::parse_changes(options.settings, used);
}

lab::CaseInput input_of(const CasesOptions& options, std::span<const lab::SettingChange> changes) {
    const double dt = lab::parse_step(options.dt);
    const lab::ContenderRequest request = lab::plain_contender(lab::engine_named(options.engine));
    lab::CaseInput input{lab::contender_for(request, Scene{}, dt, changes), dt, options.quick, {}};
    note_idle(input.contender, changes);
    return input;
}

int map_stability(const CasesOptions& options) {
    const auto changes = changes_of(options);
    const lab::CaseInput input = input_of(options, changes);
    lab::WholeFile file(options.map);
    std::vector<lab::StabilityPoint> points;
    {
        Progress progress(1);
        points = lab::stability_map(input.contender, lab::map_steps, [&](double done) { progress.at(done); });
    }
    write_stability(file.out(), input.contender, points);
    file.finish();
    const auto stable =
        std::ranges::count_if(points, [](const lab::StabilityPoint& point) { return point.failure.empty(); });
    print("Stable in %td of %zu runs, mass ratio x speed x step\n", stable, points.size());
    return 0;
}

/// The scenes that hunts found: what was recorded, and every engine on them as it comes.
int run_hard() {
    namespace hunts = lab::hunt;
    const std::string others[] = {"custom=custom", "simple=custom,solver=simple", "box2d=box2d"};
    const std::vector<lab::ContenderRequest> contenders = lab::parse_contenders(others);
    print("%-28s %-8s %-10s %10s %10s", "scene", "goal", "worst of", "recorded", "now");
    for (const lab::ContenderRequest& contender : contenders) print(" %10s", contender.name.c_str());
    print("\n");
    bool grew = false;
    for (const hunts::HardScene& hard : hunts::hard_scenes(hunts::hard_folder())) {
        const Scene scene = load_scene(hunts::hard_folder() / hard.scene);
        const double now = measure(hard.request, scene).value;
        grew = grew || now > hunts::may_grow * hard.recorded;
        print("%-28s %-8s %-10s %10.3g %10.3g", printable(hard.scene).c_str(),
              std::string(name_of(hard.request.goal)).c_str(), hard.request.contender.name.c_str(),
              hard.recorded, now);
        for (const lab::ContenderRequest& contender : contenders) {
            hunts::Request request = hard.request;
            request.contender = contender;
            print(" %10.3g", measure(request, scene).value);
        }
        print("\n");
        finish_output();
    }
    print(
        "\noverlap, error: radii; energy: share of the most that the balls can have; escape: balls; work: "
        "tests per "
        "ball and step.\n");
    return grew ? 1 : 0;
}

int run_cases(const CasesOptions& options) {
    const auto chosen = lab::find_cases(options.names);
    const auto changes = changes_of(options);
    const lab::CaseInput input = input_of(options, changes);
    OutputFile json(options.json);
    std::vector<lab::CaseRun> runs;
    print_head(input);
    for (const lab::Case* one : chosen) {
        {
            Progress progress(static_cast<double>(chosen.size()));
            progress.at(static_cast<double>(runs.size()));
            runs.push_back(run_recommended(*one, input, changes));
        }
        print_case(runs.back());
        finish_output();
    }
    if (auto* out = json.out()) *out << to_json(runs, input);
    json.finish();
    print_summary(runs);
    const auto failed = [](const lab::CaseRun& run) { return run.result.verdict == lab::Verdict::fail; };
    return std::ranges::any_of(runs, failed) ? 1 : 0;
}

/// Throws where more is given than this option and what it heeds: nothing is ignored.
void require_alone(const CLI::App& command, const std::string& option,
                   std::initializer_list<std::string_view> heeded = {}) {
    std::string with;
    for (const std::string_view one : heeded) with += (with.empty() ? "" : ", ") + std::string(one);
    for (const CLI::Option* given : command.get_options())
        if (given->count() > 0 && given->get_name() != option &&
            std::ranges::find(heeded, given->get_name()) == heeded.end())
            throw InputError(option + " takes no " + given->get_name() + "; it is given " +
                             (with.empty() ? "alone" : "alone or with " + with));
}

}  // namespace

void add_cases(CLI::App& program, Action& chosen) {
    auto options = std::make_shared<CasesOptions>();
    CLI::App& command = *program.add_subcommand(
        "cases", "Run experiments with known answers: expected against measured (exit 1 where one failed)");
    command.add_option("names", options->names, "Names or numbers (default: all; --list shows them)")
        ->type_name("CASE");
    command.add_option("--engine", options->engine, "The engine (see `flipside engines`)")
        ->capture_default_str()
        ->type_name("E");
    command.add_option("--dt", options->dt, "Step, s, as 0.01 or 1/60")
        ->capture_default_str()
        ->type_name("H");
    command.add_option("--set", options->settings, "A setting of the engine; may be given several times")
        ->allow_extra_args(false)
        ->type_name("K=V");
    command.add_flag("--quick", options->quick, "Fewer hits and shorter runs; the rows name the numbers");
    command.add_flag("--list", options->list, "List the cases, a sentence each");
    command.add_flag(
        "--hard", options->hard,
        "Instead of the cases: ours and Box2D on the scenes that hunts found (exit 1 where one got worse)");
    command.add_option("--json", options->json, "Everything found, as JSON")->type_name("FILE");
    command
        .add_option("--map", options->map,
                    "Instead of the cases: where the engine holds, mass ratio x speed x step, as CSV")
        ->type_name("FILE");
    command.callback([options, &command, &chosen] {
        if (options->list) require_alone(command, "--list");
        if (options->hard) require_alone(command, "--hard");
        if (!options->map.empty()) require_alone(command, "--map", {"--engine", "--set"});
        chosen = [options] {
            if (options->list) return list_cases();
            if (options->hard) return run_hard();
            static_cast<void>(lab::engine_named(options->engine));
            require_distinct({{}, {{"--json", options->json}, {"--map", options->map}}, true});
            return options->map.empty() ? run_cases(*options) : map_stability(*options);
        };
    });
}

}  // namespace flipside::app

#include "lab/conformance/conformance.hpp"

#include <algorithm>

#include "app/cli/commands.hpp"
#include "app/cli/distinct_files.hpp"
#include "app/cli/output.hpp"
#include "app/cli/output_file.hpp"
#include "app/cli/progress.hpp"

namespace flipside::app {

namespace {

struct ConformanceOptions {
    std::string file, json;  ///< json: "" where not asked for
};

void print_marks(const lab::Conformance& conformance) {
    const std::string what =
        conformance.engine + (conformance.library.empty() ? "" : ", " + conformance.library);
    print("%s%s%s\n\n", conformance.file.c_str(), what.empty() ? "" : ": ", what.c_str());
    for (const lab::Mark& mark : conformance.marks) {
        print("%-13s %2d of %2d  %-11s %s\n", mark.name.c_str(), mark.points, mark.of,
              std::string(name_of(mark.grade)).c_str(), mark.asks.c_str());
        print("%33s%s\n", "", mark.says.c_str());
    }
    print("\n%d of %d points; %s\n", conformance.points(), conformance.of(),
          conformance.passed()
              ? "passed: all that is mandatory is there, and nothing that is declared is wrong"
              : "not passed: see what fails above");
}

int check(const ConformanceOptions& options) {
    require_distinct({{{"the library", options.file}}, {{"--json", options.json}}, true});
    OutputFile json(options.json);
    const lab::Conformance conformance = [&] {
        Progress progress(1);
        return lab::check_conformance(options.file, [&](double share) { progress.at(share); });
    }();
    if (auto* out = json.out()) *out << to_json(conformance);
    json.finish();
    print_marks(conformance);
    return conformance.passed() ? 0 : 1;
}

}  // namespace

void add_conformance(CLI::App& program, Action& chosen) {
    auto options = std::make_shared<ConformanceOptions>();
    CLI::App& command = *program.add_subcommand(
        "conformance",
        "Mark what of the contract of flipside/engine.h a library meets (exit 1 where it fails)");
    command.add_option("file", options->file, "The library")->required()->type_name("FILE.so");
    command.add_option("--json", options->json, "The marks, as JSON")->type_name("FILE");
    command.callback([options, &chosen] { chosen = [options] { return check(*options); }; });
}

}  // namespace flipside::app

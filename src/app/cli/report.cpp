#include "lab/report/report.hpp"

#include <memory>

#include "app/cli/commands.hpp"
#include "app/cli/output.hpp"
#include "app/cli/progress.hpp"
#include "app/cli/run_options.hpp"
#include "lab/contenders/engines.hpp"
#include "world/printable.hpp"

namespace flipside::app {

namespace {

struct ReportOptions {
    std::string out;
    std::vector<std::string> from, engines;
    bool quick = false, redraw = false;
};

int report(const ReportOptions& options) {
    for (const std::string& engine : options.engines) static_cast<void>(lab::engine_named(engine));
    {
        Progress progress(1);
        const auto watch = [&](double share) { progress.at(share); };
        lab::report::make_report({options.out,
                                  {options.from.begin(), options.from.end()},
                                  options.quick ? lab::report::quick_effort() : lab::report::full_effort(),
                                  options.redraw},
                                 watch, say);
    }
    print("%s\n", printable((std::filesystem::path(options.out) / "index.html").string()).c_str());
    return 0;
}

}  // namespace

void add_report(CLI::App& program, Action& chosen) {
    auto options = std::make_shared<ReportOptions>();
    CLI::App& command = *program.add_subcommand(
        "report", "Measure speed and error of all engines, draw the figures, and write one HTML page");
    command
        .add_option("--out", options->out,
                    "The folder of the report; a report that was stopped goes on there")
        ->required()
        ->type_name("DIR");
    command
        .add_option("--from", options->from,
                    "Folders of one sweep (its shards), to be shown instead of measuring one")
        ->type_name("DIR...");
    add_libraries(command, options->engines);
    command.add_flag("--quick", options->quick, "In two minutes instead of half an hour");
    command.add_flag(
        "--redraw", options->redraw,
        "Measure nothing: draw the page and its figures again from the data in DIR, whichever build "
        "measured them");
    command.callback([options, &chosen] { chosen = [options] { return report(*options); }; });
}

}  // namespace flipside::app

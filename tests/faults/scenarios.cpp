#include "scenarios.hpp"

#include <fstream>
#include <stdexcept>

#include "places.hpp"

namespace flipside::faults {

namespace fs = std::filesystem;

namespace {

const std::vector<std::string> sweep_command{test::flipside_program,
                                             "sweep",
                                             "drop",
                                             "--contenders",
                                             "box2d",
                                             "--finest",
                                             "30",
                                             "--quick",
                                             "--out",
                                             "sweep"};

}  // namespace

Scenarios::Scenarios(fs::path base) : base_(std::move(base)) {
    for (const char* folder : {"run", "empty", "swept", "reported"}) fs::create_directories(base_ / folder);
    for (const char* old : {"a.csv", "b.csv", "c.json", "d.json"})
        std::ofstream(base_ / "run" / old) << "what was here\n";
}

Scenarios::~Scenarios() {
    std::error_code none;
    fs::remove_all(base_, none);
}

Scenario Scenarios::run() const {
    return {"run",
            {test::flipside_program, "run", "toy", "--engine", "custom", "--seconds", "0.5", "--script",
             "none", "--out", "a.csv", "--events", "b.csv", "--stats", "c.json", "--save", "d.json"},
            base_ / "run",
            "flipside"};
}

Scenario Scenarios::sweep_begin() const {
    std::vector<std::string> command = sweep_command;
    command.insert(command.end(), {"--shard", "1/4"});
    return {"the begin of a sweep", command, base_ / "empty", "flipside"};
}

Scenario Scenarios::sweep_end() const {
    const Scenario scenario{"the end of a sweep", sweep_command, base_ / "swept", "flipside"};
    if (fs::is_empty(scenario.folder)) {
        run_undisturbed(scenario, scenario.folder);
        for (const char* file : {"sweep.csv", "windows/drop-004.json", "runs/drop-004.csv"})
            fs::remove(scenario.folder / "sweep" / file);
    }
    return scenario;
}

Scenario Scenarios::report(const std::string& program) const {
    const Scenario scenario{"a report", {test::tiny_report, "report"}, base_ / "reported", program};
    if (fs::is_empty(scenario.folder)) {
        run_undisturbed(scenario, scenario.folder);
        fs::remove(scenario.folder / "report" / "data" / "energy-drop-custom-continuous.csv");
        fs::remove(scenario.folder / "report" / "index.html");
    }
    return scenario;
}

void run_undisturbed(const Scenario& scenario, const fs::path& folder) {
    const Ended ended = Child(scenario.command, folder).wait(300);
    if (ended.code != 0)
        throw std::runtime_error(scenario.name + " ends with code " + std::to_string(ended.code) + ": " +
                                 ended.err);
}

}  // namespace flipside::faults

#pragma once
/// Runs another program and waits for it. No shell is involved: arguments arrive as they are.

#include <filesystem>
#include <string>
#include <vector>

namespace flipside::lab::report {

struct Finished {
    int code;          ///< its exit code; 128 + N where signal N ended it
    std::string said;  ///< what it wrote to stdout and stderr
};
/// The program is looked for in PATH, runs in `folder` and has nothing to read. Throws Failure when it cannot
/// be started.
[[nodiscard]] Finished run_program(const std::vector<std::string>& command,
                                   const std::filesystem::path& folder = ".");

}  // namespace flipside::lab::report

#pragma once
/// Commands that write files, small enough to be run hundreds of times, and what they write when nothing
/// fails.

#include <filesystem>
#include <string>
#include <vector>

#include "folders.hpp"

namespace flipside::faults {

struct Scenario {
    std::string name;
    std::vector<std::string> command;
    std::filesystem::path folder;  ///< in which it runs, as it is before
    std::string program;           ///< whose calls fail: that of the command, or one that it starts
};

/// Makes the folders of the scenarios below `base` and removes them at the end.
class Scenarios {
  public:
    explicit Scenarios(std::filesystem::path base);
    ~Scenarios();
    Scenarios(const Scenarios&) = delete;
    Scenarios& operator=(const Scenarios&) = delete;

    [[nodiscard]] const std::filesystem::path& base() const { return base_; }
    /// A run that writes all its files, where there are old ones of these names.
    [[nodiscard]] Scenario run() const;
    /// The first unit of a sweep, in an empty folder.
    [[nodiscard]] Scenario sweep_begin() const;
    /// The last unit of a sweep, and its figures.
    [[nodiscard]] Scenario sweep_end() const;
    /// A report of which one measurement is missing; faults are those of `program`.
    [[nodiscard]] Scenario report(const std::string& program) const;

  private:
    std::filesystem::path base_;
};

/// Ends with code 0, or the test has no ground to stand on.
void run_undisturbed(const Scenario& scenario, const std::filesystem::path& folder);

}  // namespace flipside::faults

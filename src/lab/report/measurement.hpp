#pragma once
/// The measurements of a report. Each has a data file (data_file.hpp) of its own; what is there and whole is
/// not measured again, so a report that was stopped goes on where it was.

#include <filesystem>
#include <functional>
#include <span>
#include <string>

#include "lab/files/data_file.hpp"

namespace flipside::lab::report {

/// Told how much of the work is done, 0 … 1; may throw to stop it.
using Watch = std::function<void(double share)>;

/// What measuring took so far.
struct Spent {
    double cpu_seconds = 0;
    double most_load = 0;  ///< programs that ran or waited for a processor, mean of a minute; the largest
};

/// The folder of a report's data.
class Data {
  public:
    /// `effort` decides, with the commit of the build that measures, what the files hold.
    Data(std::filesystem::path folder, const std::string& effort, const std::string& commit, Notice notice);

    [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
    [[nodiscard]] const Notice& notice() const { return notice_; }
    [[nodiscard]] std::filesystem::path path(const std::string& file) const { return folder_ / file; }
    /// Whether the file is there; one that is damaged is not, and the notice is told so.
    [[nodiscard]] bool has(const std::string& file) const;
    /// Throws InputError where the file is missing or damaged.
    [[nodiscard]] std::string read(const std::string& file) const;
    void write(const std::string& file, const std::string& text) const;
    /// Nothing where nothing was measured yet.
    [[nodiscard]] Spent spent() const;
    /// Adds what a measurement took.
    void spend(double cpu_seconds) const;

  private:
    [[nodiscard]] std::string origin(const std::string& file) const;

    std::filesystem::path folder_;
    std::string origin_;
    Notice notice_;
};

struct Measurement {
    double seconds = 1;  ///< CPU time it takes, about: for the progress
    std::function<bool(const Data& data)> is_done;
    std::function<void(const Data& data, const Watch& watch)> take;  ///< writes its files
};
/// One whose only file holds the text that `measure` returns.
[[nodiscard]] Measurement measurement_of_file(const std::string& file, double seconds,
                                              std::function<std::string(const Watch& watch)> measure);

/// Takes those that are not done, in their order.
void take(std::span<const Measurement> measurements, const Data& data, const Watch& watch);

}  // namespace flipside::lab::report

#pragma once
/// A file that is there as a whole or not at all: written beside its place, renamed into it when done.

#include <filesystem>
#include <fstream>
#include <string_view>

namespace flipside::lab {

class WholeFile {
  public:
    /// What is no plain file (a pipe, a device, a link as /dev/stdout is) is written directly. Throws Failure
    /// when it cannot be opened.
    explicit WholeFile(std::filesystem::path target);
    /// Without finish() nothing is left behind.
    ~WholeFile();
    WholeFile(const WholeFile&) = delete;
    WholeFile& operator=(const WholeFile&) = delete;

    [[nodiscard]] std::ostream& out() { return out_; }
    /// Puts the file into its place. Throws Failure when not all of it could be written.
    void finish();

  private:
    std::filesystem::path target_;
    std::filesystem::path written_;  ///< the temporary file; target_ itself where written directly
    std::ofstream out_;
};

void write_whole_file(const std::filesystem::path& target, std::string_view text);

}  // namespace flipside::lab

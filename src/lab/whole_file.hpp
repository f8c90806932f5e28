#pragma once
/// A file that is there as a whole or not at all, also after the power fails: written beside its place,
/// synced to disk, renamed into its place, and the folder synced.

#include <filesystem>
#include <ostream>
#include <string_view>

#include "lab/output_buffer.hpp"

namespace flipside::lab {

/// Without finish() nothing is left behind.
class WholeFile {
  public:
    /// A link stays a link: what it leads to is replaced. What is no plain file (a pipe, a device, what a
    /// link in /dev or /proc leads to, as /dev/stdout does) is written directly. Throws Failure when it
    /// cannot be opened.
    explicit WholeFile(std::filesystem::path target);

    /// Output to it throws Failure as soon as something cannot be written.
    [[nodiscard]] std::ostream& out() { return out_; }
    /// Puts the file into its place. Throws Failure when it could not be written, synced or renamed; then
    /// what was in its place is still there, unless it is only the folder that could not be synced.
    void finish();

  private:
    /// The open file, which may be a temporary one. At the end it is closed, and removed if it still is one.
    struct Draft {
        std::filesystem::path path;
        bool is_temporary;
        int descriptor = -1;

        Draft(const std::filesystem::path& target, const std::filesystem::path& place);
        ~Draft();
        Draft(const Draft&) = delete;
        Draft& operator=(const Draft&) = delete;
        /// Returns 0 or the errno of the system's close().
        int close();
    };

    std::filesystem::path target_;  ///< as it was asked for
    std::filesystem::path place_;   ///< where its links lead
    Draft draft_;
    OutputBuffer buffer_;
    std::ostream out_;
};

void write_whole_file(const std::filesystem::path& target, std::string_view text);

}  // namespace flipside::lab

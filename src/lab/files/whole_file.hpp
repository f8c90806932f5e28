#pragma once
/// A file that is there as a whole or not at all, also after the power fails: written beside its place,
/// synced to disk, renamed into its place, and the folder synced.

#include <filesystem>
#include <optional>
#include <ostream>
#include <string_view>

#include "lab/files/output_buffer.hpp"
#include "lab/process/unfinished.hpp"

namespace flipside::lab {

/// A name for a file beside the place that it shall take. At the end the file is removed if it is there, also
/// when a signal ends the program (unfinished.hpp).
class TemporaryFile {
  public:
    explicit TemporaryFile(const std::filesystem::path& place);
    ~TemporaryFile();
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
    UnfinishedFile unfinished_;
};

/// Without finish() nothing is left behind.
class WholeFile {
  public:
    /// A link stays a link: what it leads to is replaced, and keeps its permissions. What is no plain file (a
    /// pipe, a device, what a link in /dev or /proc leads to, as /dev/stdout does) is written directly.
    /// Throws InputError where the path is wrong (path_error.hpp), Failure where it cannot be opened for
    /// another reason.
    explicit WholeFile(std::filesystem::path target);
    ~WholeFile();
    WholeFile(const WholeFile&) = delete;
    WholeFile& operator=(const WholeFile&) = delete;

    /// Output to it throws Failure as soon as something cannot be written.
    [[nodiscard]] std::ostream& out() { return out_; }
    /// The open file, for another program to write what `out` does not.
    [[nodiscard]] int descriptor() const { return descriptor_; }
    /// Puts the file into its place. Throws Failure when it could not be written, synced or renamed; then
    /// what was in its place is still there, unless it is only the folder that could not be synced.
    void finish();

  private:
    std::filesystem::path target_;  ///< as it was asked for
    std::filesystem::path place_;   ///< where its links lead
    bool is_direct_;                ///< written into its place
    TemporaryFile temporary_;
    int descriptor_;
    OutputBuffer buffer_;
    std::ostream out_;
};

/// With those it is in. Throws Failure when it cannot be made.
void make_folder(const std::filesystem::path& folder);

void write_whole_file(const std::filesystem::path& target, std::string_view text);

}  // namespace flipside::lab

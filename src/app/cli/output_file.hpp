#pragma once
/// A file that a command writes at its end, where it was asked for. It is opened before the work begins: a
/// path that cannot be written is told at once, not after an hour.

#include <filesystem>
#include <optional>

#include "lab/files/whole_file.hpp"

namespace flipside::app {

class OutputFile {
  public:
    /// An empty path is that of a file that was not asked for. Throws InputError where the path is wrong
    /// (path_error.hpp), Failure where the file cannot be opened for another reason.
    explicit OutputFile(const std::filesystem::path& path) {
        if (!path.empty()) file_.emplace(path);
    }
    /// Null where it was not asked for.
    [[nodiscard]] std::ostream* out() { return file_ ? &file_->out() : nullptr; }
    /// Puts the file into its place. Without it nothing is left behind.
    void finish() {
        if (file_) file_->finish();
    }

  private:
    std::optional<lab::WholeFile> file_;
};

}  // namespace flipside::app

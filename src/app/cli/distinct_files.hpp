#pragma once
/// A command must not write over what it reads, nor twice over the same file.

#include <filesystem>
#include <string>
#include <vector>

namespace flipside::app {

/// A file that a command reads or writes, and what the command line calls it: "--out", "the scene".
struct NamedFile {
    std::string what;
    std::filesystem::path path;  ///< empty: not asked for
};

struct FilesOfCommand {
    std::vector<NamedFile> inputs, outputs;
    bool prints = false;  ///< on stdout too, whatever the outputs are
};

/// Throws InputError where an output is also an input or another output. Files are compared by what they are,
/// not by name: hard links, symbolic links (of files yet to be made, too) and "./x" are seen through. Where
/// the command prints, a regular file behind stdout counts as an output. /dev/null may be named often. The
/// libraries of all engines that were loaded before are inputs too.
void require_distinct(const FilesOfCommand& files);

}  // namespace flipside::app

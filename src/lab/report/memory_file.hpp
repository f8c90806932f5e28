#pragma once
/// A file in memory, without a name in any folder: for what another program writes and we read. It ends with
/// the programs that hold it, however they end.

#include <cerrno>
#include <filesystem>
#include <string>
#include <system_error>

#include <sys/mman.h>
#include <unistd.h>

#include "lab/process/failure.hpp"

namespace flipside::lab::report {

class MemoryFile {
  public:
    /// Throws Failure where the system gives none. Programs started later inherit it.
    MemoryFile() : descriptor_(memfd_create("flipside", 0)) {
        if (descriptor_ < 0)
            throw Failure("no file in memory (" + std::generic_category().message(errno) + ")");
    }
    ~MemoryFile() { close(descriptor_); }
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;

    /// By which it can be opened, here and in a program that inherited it.
    [[nodiscard]] std::filesystem::path path() const { return "/dev/fd/" + std::to_string(descriptor_); }

  private:
    int descriptor_;
};

}  // namespace flipside::lab::report

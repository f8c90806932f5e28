#pragma once
/// Starts another program. No shell is involved: arguments arrive as they are.

#include <filesystem>
#include <string>
#include <vector>

#include <sys/types.h>

namespace flipside::lab {

/// What it has in place of ours. It gets no other file of ours that closes on exec.
struct Streams {
    int in = -1;  ///< a descriptor; −1: it has nothing to read
    int out = 1, err = 2;
};

/// A program that is looked for in PATH and runs in `folder`, in a process group of its own and with no
/// signal ignored or blocked. Returns what the system says, 0 where it started as `child`. To be noted by
/// UnfinishedChild.
[[nodiscard]] int spawn(pid_t& child, const std::vector<std::string>& command, const Streams& streams,
                        const std::filesystem::path& folder = ".");
/// Waits for its end; its exit code, 128 + N where signal N ended it.
[[nodiscard]] int wait_for(pid_t child);

}  // namespace flipside::lab

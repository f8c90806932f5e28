#pragma once
/// What must not outlive the program when a signal ends it at once, in the middle of a step that may last
/// for minutes: temporary files, and child processes that write files. On every other way destructors see to
/// them.

#include <filesystem>
#include <functional>

#include <sys/types.h>

namespace flipside::lab {

/// Notes a file that is about to be created, for as long as it is not whole.
class UnfinishedFile {
  public:
    /// Throws Failure when more than 64 are noted at a time.
    explicit UnfinishedFile(const std::filesystem::path& file);
    ~UnfinishedFile();
    UnfinishedFile(const UnfinishedFile&) = delete;
    UnfinishedFile& operator=(const UnfinishedFile&) = delete;

  private:
    std::size_t slot_;
};

/// Starts a child by `start()`, which returns its id or 0, and notes it before any signal is answered.
/// One at a time.
class UnfinishedChild {
  public:
    explicit UnfinishedChild(const std::function<pid_t()>& start) {
        const HeldSignals held;
        note(start());
    }
    ~UnfinishedChild() { note(0); }
    UnfinishedChild(const UnfinishedChild&) = delete;
    UnfinishedChild& operator=(const UnfinishedChild&) = delete;

  private:
    /// While it lives, SIGINT and SIGTERM wait.
    class HeldSignals {
      public:
        HeldSignals();
        ~HeldSignals();
        HeldSignals(const HeldSignals&) = delete;
        HeldSignals& operator=(const HeldSignals&) = delete;
    };
    static void note(pid_t id);
};

/// Kills the noted child with its process group, waits until it has ended, and removes the noted files. Safe
/// in a signal handler, and meant for one that then ends the program.
void abandon_unfinished() noexcept;

}  // namespace flipside::lab

#include "lab/process/unfinished.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <climits>
#include <csignal>
#include <string>

#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include "lab/process/failure.hpp"

namespace flipside::lab {

namespace {

/// A signal handler may read these at any instant: no allocation, no locks.
struct Slot {
    std::atomic<bool> used = false;
    std::array<char, PATH_MAX> path{};
};
constexpr std::size_t most_files = 64;
std::array<Slot, most_files> slots;
std::atomic<pid_t> child = 0;
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<pid_t>::is_always_lock_free);

sigset_t stopping_signals() {
    sigset_t set;
    sigemptyset(&set);
    sigaddset(&set, SIGINT);
    sigaddset(&set, SIGTERM);
    return set;
}

/// A killed child goes on until the system call that it is in ends. Half a second at most; of the ways to
/// wait for a millisecond poll() is one that a signal handler may use.
void wait_for_end(pid_t id) noexcept {
    for (int millisecond = 0; millisecond < 500; ++millisecond) {
        if (waitpid(id, nullptr, WNOHANG) != 0) return;
        poll(nullptr, 0, 1);
    }
}

}  // namespace

UnfinishedFile::UnfinishedFile(const std::filesystem::path& file)
    : slot_(static_cast<std::size_t>(
          std::ranges::find_if_not(slots, [](const Slot& slot) { return slot.used.load(); }) -
          slots.begin())) {
    if (slot_ == most_files) throw Failure(file.string() + ": too many files are written at a time");
    const std::string& path = file.native();
    // One that is longer cannot be created either.
    if (path.size() >= PATH_MAX) return;
    std::ranges::copy(path, slots[slot_].path.begin());
    slots[slot_].path[path.size()] = '\0';
    slots[slot_].used = true;
}

UnfinishedFile::~UnfinishedFile() {
    slots[slot_].used = false;
}

UnfinishedChild::HeldSignals::HeldSignals() {
    const sigset_t set = stopping_signals();
    sigprocmask(SIG_BLOCK, &set, nullptr);
}

UnfinishedChild::HeldSignals::~HeldSignals() {
    const sigset_t set = stopping_signals();
    sigprocmask(SIG_UNBLOCK, &set, nullptr);
}

void UnfinishedChild::note(pid_t id) {
    child = id;
}

void abandon_unfinished() noexcept {
    if (const pid_t id = child; id > 0) {
        kill(-id, SIGKILL);
        wait_for_end(id);
    }
    for (const Slot& slot : slots)
        if (slot.used) unlink(slot.path.data());
}

}  // namespace flipside::lab

#include "lab/process/spawn.hpp"

#include <cerrno>
#include <csignal>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace flipside::lab {

namespace {

/// What the child does with its files before it starts.
class FileActions {
  public:
    FileActions(const Streams& streams, const std::filesystem::path& folder) {
        posix_spawn_file_actions_init(&actions_);
        posix_spawn_file_actions_addchdir_np(&actions_, folder.c_str());
        if (streams.in < 0)
            posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
        else
            posix_spawn_file_actions_adddup2(&actions_, streams.in, STDIN_FILENO);
        posix_spawn_file_actions_adddup2(&actions_, streams.out, STDOUT_FILENO);
        posix_spawn_file_actions_adddup2(&actions_, streams.err, STDERR_FILENO);
    }
    ~FileActions() { posix_spawn_file_actions_destroy(&actions_); }
    FileActions(const FileActions&) = delete;
    FileActions& operator=(const FileActions&) = delete;

    [[nodiscard]] const posix_spawn_file_actions_t* get() const { return &actions_; }

  private:
    posix_spawn_file_actions_t actions_{};
};

/// A process group of its own, which is killed as one where a signal ends us; and no signal is blocked.
class Attributes {
  public:
    Attributes() {
        posix_spawnattr_init(&attributes_);
        // Signals that we ignore would stay ignored in the child, and those that wait here would wait there.
        sigset_t usual, none;
        sigemptyset(&usual);
        sigaddset(&usual, SIGPIPE);
        sigaddset(&usual, SIGXFSZ);
        sigemptyset(&none);
        posix_spawnattr_setsigdefault(&attributes_, &usual);
        posix_spawnattr_setsigmask(&attributes_, &none);
        posix_spawnattr_setflags(&attributes_,
                                 POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK);
    }
    ~Attributes() { posix_spawnattr_destroy(&attributes_); }
    Attributes(const Attributes&) = delete;
    Attributes& operator=(const Attributes&) = delete;

    [[nodiscard]] const posix_spawnattr_t* get() const { return &attributes_; }

  private:
    posix_spawnattr_t attributes_{};
};

}  // namespace

int spawn(pid_t& child, const std::vector<std::string>& command, const Streams& streams,
          const std::filesystem::path& folder) {
    std::vector<char*> arguments;
    for (const std::string& argument : command) arguments.push_back(const_cast<char*>(argument.c_str()));
    arguments.push_back(nullptr);
    const FileActions actions(streams, folder);
    const Attributes attributes;
    return posix_spawnp(&child, arguments[0], actions.get(), attributes.get(), arguments.data(), environ);
}

int wait_for(pid_t child) {
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace flipside::lab

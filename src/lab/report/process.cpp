#include "lab/report/process.hpp"

#include <cerrno>
#include <csignal>
#include <system_error>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "lab/process/failure.hpp"
#include "lab/process/unfinished.hpp"

extern char** environ;

namespace flipside::lab::report {

namespace {

/// What the child does with its files before it starts.
class FileActions {
  public:
    FileActions(const int (&pipe)[2], const std::filesystem::path& folder) {
        posix_spawn_file_actions_init(&actions_);
        posix_spawn_file_actions_addchdir_np(&actions_, folder.c_str());
        posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
        posix_spawn_file_actions_adddup2(&actions_, pipe[1], STDOUT_FILENO);
        posix_spawn_file_actions_adddup2(&actions_, pipe[1], STDERR_FILENO);
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

[[noreturn]] void fail(const std::string& program, int error) {
    throw Failure(program + ": cannot be run (" + std::generic_category().message(error) + ")");
}

/// Everything until the other end is closed.
std::string read_all(int from) {
    std::string all;
    char primitive[4096];
    for (;;) {
        const ssize_t size = read(from, primitive, sizeof primitive);
        if (size > 0) all.append(primitive, static_cast<std::size_t>(size));
        if (size == 0 || (size < 0 && errno != EINTR)) return all;
    }
}

}  // namespace

Finished run_program(const std::vector<std::string>& command, const std::filesystem::path& folder) {
    std::vector<char*> arguments;
    for (const std::string& argument : command) arguments.push_back(const_cast<char*>(argument.c_str()));
    arguments.push_back(nullptr);

    int pipe[2];
    if (pipe2(pipe, O_CLOEXEC) != 0) fail(command.front(), errno);
    pid_t child = 0;
    const FileActions actions(pipe, folder);
    const Attributes attributes;
    int error = 0;
    const UnfinishedChild noted([&] {
        error =
            posix_spawnp(&child, arguments[0], actions.get(), attributes.get(), arguments.data(), environ);
        return error == 0 ? child : 0;
    });
    close(pipe[1]);
    const std::string said = error == 0 ? read_all(pipe[0]) : "";
    close(pipe[0]);
    if (error != 0) fail(command.front(), error);

    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), said};
}

}  // namespace flipside::lab::report

#include "lab/report/process.hpp"

#include <cerrno>
#include <system_error>

#include <fcntl.h>
#include <unistd.h>

#include "lab/process/failure.hpp"
#include "lab/process/spawn.hpp"
#include "lab/process/unfinished.hpp"

namespace flipside::lab::report {

namespace {

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
    int pipe[2];
    if (pipe2(pipe, O_CLOEXEC) != 0) fail(command.front(), errno);
    pid_t child = 0;
    int error = 0;
    const UnfinishedChild noted([&] {
        error = spawn(child, command, {-1, pipe[1], pipe[1]}, folder);
        return error == 0 ? child : 0;
    });
    close(pipe[1]);
    const std::string said = error == 0 ? read_all(pipe[0]) : "";
    close(pipe[0]);
    if (error != 0) fail(command.front(), error);

    return {wait_for(child), said};
}

}  // namespace flipside::lab::report

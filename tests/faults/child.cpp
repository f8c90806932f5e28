#include "child.hpp"

#include <cerrno>
#include <chrono>
#include <csignal>
#include <fstream>
#include <sstream>
#include <system_error>
#include <thread>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace flipside::faults {

namespace fs = std::filesystem;

namespace {

std::vector<char*> pointers(const std::vector<std::string>& texts) {
    std::vector<char*> all;
    for (const std::string& text : texts) all.push_back(const_cast<char*>(text.c_str()));
    all.push_back(nullptr);
    return all;
}

/// In the child, where only functions that are safe after fork() may be called.
[[noreturn]] void become(char* const* arguments, char* const* environment, const char* folder,
                         const char* err) {
    constexpr mode_t mode = 0600;
    const int none = open("/dev/null", O_RDWR), said = open(err, O_WRONLY | O_CREAT | O_TRUNC, mode);
    if (chdir(folder) == 0 && dup2(none, STDIN_FILENO) >= 0 && dup2(none, STDOUT_FILENO) >= 0 &&
        dup2(said, STDERR_FILENO) >= 0)
        execve(arguments[0], arguments, environment);
    _exit(127);
}

}  // namespace

Child::Child(const std::vector<std::string>& command, const fs::path& folder,
             const std::vector<std::string>& variables) {
    static int number = 0;
    err_ = fs::temp_directory_path() /
           ("flipside-err-" + std::to_string(getpid()) + "-" + std::to_string(number++));
    std::vector<std::string> environment = variables;
    for (char** variable = environ; *variable != nullptr; ++variable) environment.emplace_back(*variable);
    const auto arguments = pointers(command), all = pointers(environment);
    pid_ = fork();
    if (pid_ < 0) throw std::system_error(errno, std::generic_category(), "fork");
    if (pid_ == 0) become(arguments.data(), all.data(), folder.c_str(), err_.c_str());
}

Child::~Child() {
    if (pid_ != 0) {
        signal(SIGKILL);
        waitpid(pid_, nullptr, 0);
    }
    std::error_code none;
    fs::remove(err_, none);
}

void Child::signal(int number) const {
    kill(pid_, number);
}

Ended Child::wait(double seconds) {
    using Clock = std::chrono::steady_clock;
    const auto end = Clock::now() + std::chrono::duration<double>(seconds);
    int status = 0;
    while (waitpid(pid_, &status, WNOHANG) == 0) {
        if (Clock::now() > end) signal(SIGKILL);
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    pid_ = 0;
    std::ostringstream err;
    err << std::ifstream(err_).rdbuf();
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status), err.str()};
}

}  // namespace flipside::faults

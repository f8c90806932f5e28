#pragma once
/// A program that runs beside the test, and what became of it.

#include <filesystem>
#include <string>
#include <vector>

#include <sys/types.h>

namespace flipside::faults {

struct Ended {
    int code = 0;     ///< exit code; minus the number of the signal that ended it
    std::string err;  ///< what it wrote to stderr
};

class Child {
  public:
    /// Runs in `folder` with these variables ("A=B") beside those of the test. Nobody reads its stdout.
    Child(const std::vector<std::string>& command, const std::filesystem::path& folder,
          const std::vector<std::string>& variables = {});
    /// Kills it where it still runs.
    ~Child();
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;

    void signal(int number) const;
    /// Waits for at most this long, and then kills it: code is -SIGKILL.
    Ended wait(double seconds = 60);

  private:
    pid_t pid_ = 0;  ///< 0 once it has ended
    std::filesystem::path err_;
};

}  // namespace flipside::faults

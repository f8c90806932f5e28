#pragma once
/// The real program in a real window on a virtual display, used with real keys and clicks, and watched
/// through the state that it reports. Nothing here waits for a fixed time: it waits for what should
/// happen, and gives up after a time that a slow machine does not need.

#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>
#include <sys/types.h>

namespace flipside::app {

/// A program that runs beside the test, and is ended with it.
class Process {
  public:
    Process() = default;
    /// `fd` stays open in the program.
    explicit Process(const std::vector<std::string>& command, int fd = -1);
    ~Process() { stop(); }
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;
    Process(Process&& other) noexcept { std::swap(pid_, other.pid_); }
    Process& operator=(Process&& other) noexcept {
        std::swap(pid_, other.pid_);
        return *this;
    }

    void stop();
    /// It stands still until go_on().
    void hold() const;
    void go_on() const;
    [[nodiscard]] bool running();
    /// Waits for its end; its exit code, or -1 if it goes on for more than `seconds`.
    int wait(double seconds);

  private:
    pid_t pid_ = -1;
    int status_ = 0;
};

/// Xvfb on a display number of its own choice; sets DISPLAY for this program and all it starts.
class VirtualDisplay {
  public:
    explicit VirtualDisplay(const std::string& size = "1920x1080");

  private:
    Process server_;
};

class RealWindow {
  public:
    using Json = nlohmann::json;
    using Condition = std::function<bool(const Json&)>;

    /// Starts `flipside play` with these arguments and waits for its first report. Whatever it keeps between
    /// starts it keeps in `state_home`, or nowhere.
    explicit RealWindow(std::vector<std::string> arguments, const std::filesystem::path& state_home = {});

    /// Runs xdotool, which sends what a keyboard or mouse would.
    void xdotool(const std::string& arguments) const;
    void key(const std::string& name) const { xdotool("key " + name); }
    void click(const Json& rect, int times = 1) const;
    void resize(int width, int height) const;

    /// The first report from now on of which `condition` holds. Throws std::runtime_error, with the last
    /// report, when there is none within 60 s.
    Json wait(const std::string& what, const Condition& condition);
    /// A report written after now.
    Json now();
    /// A report after everything on the panel has come to its place.
    Json settled();
    [[nodiscard]] Process& program() { return program_; }
    [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
    /// Where it lay on the display when it opened, "X,Y" in px; since then it is at 0,0.
    [[nodiscard]] const std::string& first_place() const { return first_place_; }

  private:
    /// Goes on to the next line of the report, if it is complete.
    bool read_line();

    std::filesystem::path folder_;
    std::string first_place_;
    Process program_;
    std::ifstream report_;
    std::string line_;
    bool whole_ = false;  ///< the line
    Json last_;
    std::string window_;
};

}  // namespace flipside::app

#include "app/real_window.hpp"

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <stdexcept>
#include <thread>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "places.hpp"

namespace flipside::app {

namespace {

constexpr double patience = 60;  ///< s

double clock_seconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

void nap() {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
}

std::string output_of(const std::string& command) {
    FILE* pipe = popen(command.c_str(), "r");
    if (!pipe) throw std::runtime_error("cannot run " + command);
    std::string text;
    for (int c = 0; (c = std::fgetc(pipe)) != EOF;) text += static_cast<char>(c);
    pclose(pipe);
    while (!text.empty() && text.back() == '\n') text.pop_back();
    return text;
}

/// An empty folder for one window's report and screenshots.
std::filesystem::path new_folder() {
    std::string name = (std::filesystem::temp_directory_path() / "flipside-window-XXXXXX").string();
    if (!mkdtemp(name.data())) throw std::runtime_error("cannot make a folder for the report");
    return name;
}

}  // namespace

Process::Process(const std::vector<std::string>& command, int fd) {
    pid_ = fork();
    if (pid_ < 0) throw std::runtime_error("cannot start " + command.front());
    if (pid_ > 0) return;
    std::vector<char*> words;
    words.reserve(command.size() + 1);
    for (const std::string& word : command) words.push_back(const_cast<char*>(word.c_str()));
    words.push_back(nullptr);
    if (fd >= 0) fcntl(fd, F_SETFD, 0);
    execvp(words.front(), words.data());
    _exit(127);
}

void Process::hold() const {
    kill(pid_, SIGSTOP);
}

void Process::go_on() const {
    kill(pid_, SIGCONT);
}

bool Process::running() {
    if (pid_ <= 0) return false;
    if (waitpid(pid_, &status_, WNOHANG) != pid_) return true;
    pid_ = -1;
    return false;
}

int Process::wait(double seconds) {
    for (const double end = clock_seconds() + seconds; running(); nap())
        if (clock_seconds() > end) return -1;
    return WIFEXITED(status_) ? WEXITSTATUS(status_) : -1;
}

void Process::stop() {
    if (!running()) return;
    kill(pid_, SIGTERM);
    if (wait(5) == -1 && running()) {
        kill(pid_, SIGKILL);
        wait(5);
    }
}

VirtualDisplay::VirtualDisplay(const std::string& size) {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
    server_ = Process({"Xvfb", "-displayfd", std::to_string(ends[1]), "-screen", "0", size + "x24",
                       "-noreset", "-nolisten", "tcp"},
                      ends[1]);
    close(ends[1]);
    std::string number;
    for (char c = 0; read(ends[0], &c, 1) == 1 && c != '\n';) number += c;
    close(ends[0]);
    if (number.empty())
        throw std::runtime_error("Xvfb does not start: install the packages xvfb and xdotool");
    setenv("DISPLAY", (":" + number).c_str(), 1);
    setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
    // The graphics driver leaks, and is unloaded before the leak sanitizer could be told to forgive it.
    const char* const options = std::getenv("ASAN_OPTIONS");
    setenv("ASAN_OPTIONS", (std::string(options == nullptr ? "" : options) + ":detect_leaks=0").c_str(), 1);
}

RealWindow::RealWindow(std::vector<std::string> arguments, const std::filesystem::path& state_home)
    : folder_(new_folder()) {
    setenv("XDG_STATE_HOME", (state_home.empty() ? folder_ : state_home).c_str(), 1);
    if (state_home.empty()) arguments.emplace_back("--no-settings");
    const std::filesystem::path report = folder_ / "report.jsonl";
    std::vector<std::string> command = {test::flipside_program, "play"};
    command.insert(command.end(), arguments.begin(), arguments.end());
    command.insert(command.end(), {"--report", report.string(), "--screenshots", folder_.string()});
    program_ = Process(command);
    for (const double end = clock_seconds() + patience; !exists(report); nap())
        if (clock_seconds() > end || !program_.running())
            throw std::runtime_error("the window does not start");
    report_.open(report);
    wait("a first frame", [](const Json& state) { return state["frame"] > 2; });
    for (const double end = clock_seconds() + patience; window_.empty() && clock_seconds() < end;)
        window_ = output_of("xdotool search --name '^Flipside$' | tail -n 1");
    first_place_ =
        output_of("xdotool getwindowgeometry --shell " + window_ + " | sed -n 's/^[XY]=//p' | paste -sd,");
    // Points of the window are then points of the display. Without a window manager nobody else gives it the
    // keyboard.
    xdotool("windowmove " + window_ + " 0 0");
    xdotool("windowfocus --sync " + window_);
}

void RealWindow::xdotool(const std::string& arguments) const {
    if (std::system(("xdotool " + arguments + " >/dev/null").c_str()) != 0)
        throw std::runtime_error("xdotool " + arguments + " failed");
}

void RealWindow::click(const Json& rect, int times) const {
    const auto middle = [&](std::size_t i) {
        return std::to_string(static_cast<int>(rect[i].get<double>() + 0.5 * rect[i + 2].get<double>()));
    };
    xdotool("mousemove --window " + window_ + " " + middle(0) + " " + middle(1) + " click --repeat " +
            std::to_string(times) + " --delay 60 1");
}

void RealWindow::resize(int width, int height) const {
    xdotool("windowsize " + window_ + " " + std::to_string(width) + " " + std::to_string(height));
}

bool RealWindow::read_line() {
    if (whole_) line_.clear();
    report_.clear();
    std::string more;
    std::getline(report_, more);
    line_ += more;
    whole_ = !report_.eof();
    return whole_;
}

RealWindow::Json RealWindow::wait(const std::string& what, const Condition& condition) {
    for (const double end = clock_seconds() + patience; clock_seconds() < end;) {
        if (!read_line()) {
            if (!program_.running()) throw std::runtime_error("the window ended while waiting for " + what);
            nap();
            continue;
        }
        last_ = Json::parse(line_);
        if (condition(last_)) return last_;
    }
    throw std::runtime_error("waited in vain for " + what + "; last report: " + last_.dump());
}

RealWindow::Json RealWindow::now() {
    // What lies in the file already is past.
    while (read_line()) {
    }
    return wait("a report", [](const Json&) { return true; });
}

RealWindow::Json RealWindow::settled() {
    // A click shows in a report only after the frame that is being drawn, those of the movement, the press
    // and the release, and that in which a tab comes up; what the tab holds has its place one later.
    constexpr int frames = 8;
    Json state = now();
    for (int same = 0; same < frames; ++same) {
        Json next = now();
        if (next["controls"] != state["controls"]) same = -1;
        state = std::move(next);
    }
    return state;
}

}  // namespace flipside::app

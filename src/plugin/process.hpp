#pragma once
/// The process in which a foreign engine runs: this program once more, with the library loaded. Whatever
/// happens there, here it is at worst an exception.

#include <chrono>
#include <filesystem>
#include <stdexcept>
#include <string>

#include <sys/types.h>

#include "plugin/bytes.hpp"
#include "plugin/protocol.hpp"

namespace flipside::plugin {

/// The process is gone: it crashed, ended itself, took too long, or answered nonsense. what() goes on after
/// the engine's name: "has crashed (Segmentation fault)".
struct Ended : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// It took too long.
struct Silent : Ended {
    using Ended::Ended;
};

/// Wall time in which a call must be answered.
inline constexpr std::chrono::milliseconds longest_call{10'000};

class Process {
  public:
    /// Throws std::system_error where no process can be started.
    explicit Process(const std::filesystem::path& library, std::chrono::milliseconds longest = longest_call);
    Process(const Process&) = delete;
    Process(Process&&) = delete;
    Process& operator=(const Process&) = delete;
    Process& operator=(Process&&) = delete;
    /// Ends it, with all that it has started.
    ~Process();

    /// Waits for an answer to what was asked before, or for the first one. Throws Ended.
    Answer receive(Bytes& answer);
    /// Sends, and waits for the answer. Throws Ended; from then on the process is gone.
    Answer ask(Ask kind, const Bytes& question, Bytes& answer);

    [[nodiscard]] pid_t id() const { return id_; }

  private:
    using Clock = std::chrono::steady_clock;

    void send(const void* from, std::size_t size);
    void get(void* to, std::size_t size);
    void wait_for(short events);
    void listen();
    template <class How = Ended>
    [[noreturn]] void end(const std::string& how);
    [[noreturn]] void explain_end();
    void stop();
    [[nodiscard]] std::string last_words() const;

    std::chrono::milliseconds longest_;
    Clock::time_point deadline_;
    pid_t id_ = 0;
    int socket_ = -1, output_ = -1;
    std::string said_;  ///< the end of what it wrote to its standard output and error
};

}  // namespace flipside::plugin

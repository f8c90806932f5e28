#include "plugin/worker.hpp"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string_view>

#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

#include "plugin/bytes.hpp"
#include "plugin/description.hpp"
#include "plugin/handover.hpp"
#include "plugin/library.hpp"
#include "plugin/protocol.hpp"

namespace flipside::plugin {

namespace {

/// Ends with the program, opens nothing of its, and cannot use up the machine.
void confine() {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    close_range(process_socket + 1, ~0U, 0);
    const rlimit no_core{0, 0};
    setrlimit(RLIMIT_CORE, &no_core);
#ifdef FLIPSIDE_SANITIZED
    // Its handlers would make a crash an exit; and it reserves more addresses than there is memory.
    for (const int crash : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) std::signal(crash, SIG_DFL);
#else
    const rlimit memory{std::uint64_t{4} << 30U, std::uint64_t{4} << 30U};
    setrlimit(RLIMIT_AS, &memory);
#endif
    static_cast<void>(std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ));
}

/// False if the other end is closed.
bool receive(void* to, std::size_t size) {
    char* at = static_cast<char*>(to);
    while (size > 0) {
        const ssize_t got = recv(process_socket, at, size, 0);
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) return false;
        at += got;
        size -= static_cast<std::size_t>(got);
    }
    return true;
}

void send_all(const void* from, std::size_t size) {
    const char* at = static_cast<const char*>(from);
    while (size > 0) {
        const ssize_t sent = send(process_socket, at, size, MSG_NOSIGNAL);
        if (sent < 0 && errno == EINTR) continue;
        if (sent <= 0) _exit(0);
        at += sent;
        size -= static_cast<std::size_t>(sent);
    }
}

void answer(Answer kind, const Bytes& bytes) {
    const Header header{.kind = static_cast<std::uint32_t>(kind), .size = bytes.size()};
    send_all(&header, sizeof header);
    send_all(bytes.data(), bytes.size());
}

void answer(Answer kind, std::string_view words) {
    Bytes bytes;
    Writer(bytes).text(words);
    answer(kind, bytes);
}

class Worker {
  public:
    explicit Worker(const flipside_engine& engine) : engine_(engine) {}

    /// Answers one question.
    void follow(Ask ask, const Bytes& question) {
        Reader in(question);
        Writer out(answer_);
        switch (ask) {
            case Ask::make:
                make(in);
                out.array(world_->contacts());
                break;
            case Ask::step:
                if (!step(in, out)) return answer(Answer::not_followed, answer_);
                break;
            case Ask::save:
                if (!take_controls(in)) return answer(Answer::not_followed, answer_);
                out.array(world_->save());
                break;
        }
        answer(Answer::done, answer_);
    }

  private:
    void make(Reader& in) {
        // One at a time: the old world is gone before the new one is.
        world_.reset();
        if (std::string json = in.text(); !json.empty()) json_ = std::move(json);
        scene_.read(in);
        in.array(settings_);
        in.array(memory_);
        in.finish();
        world_ = std::make_unique<ForeignWorld>(engine_, scene_.view(json_), settings_.data());
        if (!memory_.empty()) world_->restore(memory_);
        static_cast<void>(world_->take_cpu_seconds());
    }

    /// False where the engine does not follow one.
    [[nodiscard]] bool take_controls(Reader& in) {
        in.array(controls_);
        for (flipside_control& control : controls_) {
            control.size = sizeof control;
            if (!world_->control(control)) return false;
        }
        return true;
    }

    /// False where the engine does not follow a control.
    [[nodiscard]] bool step(Reader& in, Writer& out) {
        if (!take_controls(in)) return false;
        in.array(motions_);
        const auto time = in.value<double>(), dt = in.value<double>();
        const auto balls = in.value<std::uint64_t>();
        in.finish();
        static_cast<void>(world_->take_cpu_seconds());
        world_->step({.size = sizeof(flipside_step),
                      .motion_count = static_cast<std::uint32_t>(motions_.size()),
                      .motions = motions_.data(),
                      .time = time,
                      .dt = dt});
        const auto moved = world_->balls(static_cast<std::size_t>(balls));
        const auto events = world_->events();
        const auto contacts = world_->contacts();
        out.value(world_->take_cpu_seconds());
        out.array(moved);
        out.array(events);
        out.array(contacts);
        return true;
    }

    const flipside_engine& engine_;
    std::unique_ptr<ForeignWorld> world_;
    std::string json_;
    Handover scene_;
    std::vector<double> settings_;
    std::vector<std::byte> memory_;
    std::vector<flipside_control> controls_;
    std::vector<flipside_motion> motions_;
    Bytes answer_;
};

[[noreturn]] void serve(const flipside_engine& engine) {
    Worker worker(engine);
    Bytes question;
    Header header;
    while (receive(&header, sizeof header)) {
        question.resize(static_cast<std::size_t>(header.size));
        if (!receive(question.data(), question.size())) break;
        try {
            worker.follow(static_cast<Ask>(header.kind), question);
        } catch (const ForeignWorld::Refused& refused) {
            answer(Answer::refused, refused.why);
        } catch (const ForeignWorld::Broken& broken) {
            answer(Answer::broken, broken.what);
        } catch (const std::bad_alloc&) {
            answer(Answer::broken, "leaves no memory");
        }
    }
    _exit(0);
}

}  // namespace

bool is_engine_process(int argc, char** argv) {
    return argc == 3 && std::string_view(argv[1]) == process_command;
}

void run_engine_process(const char* library) {
    confine();
    try {
        const flipside_engine& engine = load_library(library);
        Bytes bytes;
        Writer out(bytes);
        describe(engine).write(out);
        answer(Answer::done, bytes);
        serve(engine);
    } catch (const std::invalid_argument& problem) {
        answer(Answer::refused, problem.what());
    }
    _exit(0);
}

}  // namespace flipside::plugin

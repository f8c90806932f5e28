#include "plugin/process.hpp"

#include <algorithm>
#include <csignal>
#include <cstring>
#include <system_error>

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include "world/printable.hpp"

namespace flipside::plugin {

namespace {

/// A process that the engine started may keep the socket open: so often we look whether the engine lives, ms.
constexpr int look_every = 50;
/// Of what the engine says, bytes kept.
constexpr std::size_t most_said = 4096;

[[noreturn]] void fail(int error, const char* what) {
    throw std::system_error(error, std::generic_category(), what);
}

/// What posix_spawn is told, freed at the end.
class SpawnPlan {
  public:
    SpawnPlan() {
        posix_spawn_file_actions_init(&actions_);
        posix_spawnattr_init(&attributes_);
        // A group of its own: what it starts ends with it, and ctrl-C at the terminal is ours alone.
        posix_spawnattr_setpgroup(&attributes_, 0);
        sigset_t defaults;
        sigfillset(&defaults);
        posix_spawnattr_setsigdefault(&attributes_, &defaults);
        sigset_t none;
        sigemptyset(&none);
        posix_spawnattr_setsigmask(&attributes_, &none);
        posix_spawnattr_setflags(&attributes_,
                                 POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK);
    }
    SpawnPlan(const SpawnPlan&) = delete;
    SpawnPlan& operator=(const SpawnPlan&) = delete;
    ~SpawnPlan() {
        posix_spawn_file_actions_destroy(&actions_);
        posix_spawnattr_destroy(&attributes_);
    }

    void use(int ours, int theirs) { posix_spawn_file_actions_adddup2(&actions_, ours, theirs); }
    void empty_input() {
        posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    }
    [[nodiscard]] pid_t start(const char* program, char* const* arguments) const {
        pid_t id = 0;
        if (const int error =
                posix_spawn(&id, program, &actions_, &attributes_, const_cast<char**>(arguments), environ))
            fail(error, "cannot start a process for an engine");
        return id;
    }

  private:
    posix_spawn_file_actions_t actions_{};
    posix_spawnattr_t attributes_{};
};

}  // namespace

Process::Process(const std::filesystem::path& library, std::chrono::milliseconds longest)
    : longest_(longest), deadline_(Clock::now() + longest) {
    int sockets[2], pipes[2];
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, sockets) != 0)
        fail(errno, "cannot make a socket for an engine");
    if (pipe2(pipes, O_CLOEXEC) != 0) {
        const int error = errno;
        close(sockets[0]);
        close(sockets[1]);
        fail(error, "cannot make a pipe for an engine");
    }
    socket_ = sockets[0];
    output_ = pipes[0];
    for (const int file : {socket_, output_}) fcntl(file, F_SETFL, fcntl(file, F_GETFL) | O_NONBLOCK);
    SpawnPlan plan;
    // The socket last: its number is the highest, so none of these closes what a later one needs.
    plan.empty_input();
    plan.use(pipes[1], STDOUT_FILENO);
    plan.use(pipes[1], STDERR_FILENO);
    plan.use(sockets[1], process_socket);
    std::string program = "flipside", command = process_command, path = library.string();
    char* const arguments[] = {program.data(), command.data(), path.data(), nullptr};
    try {
        id_ = plan.start("/proc/self/exe", arguments);
    } catch (...) {
        for (const int file : {sockets[0], sockets[1], pipes[0], pipes[1]}) close(file);
        throw;
    }
    close(sockets[1]);
    close(pipes[1]);
}

Process::~Process() {
    stop();
    close(socket_);
    close(output_);
}

void Process::stop() {
    if (id_ == 0) return;
    kill(-id_, SIGKILL);
    kill(id_, SIGKILL);
    int status = 0;
    while (waitpid(id_, &status, 0) < 0 && errno == EINTR) {
    }
    id_ = 0;
}

Answer Process::ask(Ask kind, const Bytes& question, Bytes& answer) {
    deadline_ = Clock::now() + longest_;
    const Header header{.kind = static_cast<std::uint32_t>(kind), .size = question.size()};
    send(&header, sizeof header);
    send(question.data(), question.size());
    return receive(answer);
}

Answer Process::receive(Bytes& answer) {
    Header header;
    get(&header, sizeof header);
    if (header.magic != Header{}.magic || header.size > longest_answer ||
        header.kind > static_cast<std::uint32_t>(Answer::not_followed))
        end("has written nonsense into its socket");
    // Grows as data arrives, so that a large claimed size alone allocates nothing.
    answer.clear();
    constexpr std::size_t portion = std::size_t{1} << 20U;
    while (answer.size() < header.size) {
        const std::size_t had = answer.size();
        answer.resize(had + std::min<std::size_t>(portion, header.size - had));
        get(answer.data() + had, answer.size() - had);
    }
    listen();
    return static_cast<Answer>(header.kind);
}

void Process::send(const void* from, std::size_t size) {
    if (id_ == 0) throw Ended("has ended already");
    const char* at = static_cast<const char*>(from);
    while (size > 0) {
        const ssize_t sent = ::send(socket_, at, size, MSG_NOSIGNAL);
        if (sent > 0) {
            at += sent;
            size -= static_cast<std::size_t>(sent);
        } else if (sent < 0 && (errno == EAGAIN || errno == EINTR)) {
            wait_for(POLLOUT);
        } else {
            explain_end();
        }
    }
}

void Process::get(void* to, std::size_t size) {
    if (id_ == 0) throw Ended("has ended already");
    char* at = static_cast<char*>(to);
    while (size > 0) {
        const ssize_t got = recv(socket_, at, size, 0);
        if (got > 0) {
            at += got;
            size -= static_cast<std::size_t>(got);
        } else if (got < 0 && (errno == EAGAIN || errno == EINTR)) {
            wait_for(POLLIN);
        } else {
            explain_end();
        }
    }
}

/// Until the socket is ready, or a while has passed in which the process lived.
void Process::wait_for(short events) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(deadline_ - Clock::now()).count();
    if (left <= 0)
        end<Silent>("has not answered for " + std::to_string(longest_.count()) +
                    " ms, the most that a call may take");
    pollfd files[] = {{socket_, events, 0}, {output_, POLLIN, 0}};
    const int ready = poll(files, 2, static_cast<int>(std::min<std::int64_t>(left, look_every)));
    if (ready > 0 && files[1].revents != 0) {
        listen();
        // The other end is closed: poll would return at once for ever.
        if ((files[1].revents & POLLIN) == 0 && files[0].revents == 0) poll(files, 1, 1);
    }
    siginfo_t gone{};
    if (files[0].revents == 0 &&
        waitid(P_PID, static_cast<id_t>(id_), &gone, WEXITED | WNOHANG | WNOWAIT) == 0 && gone.si_pid == id_)
        explain_end();
}

/// Takes what the engine has said, so that it never waits for a reader.
void Process::listen() {
    char words[1024];
    for (;;) {
        const ssize_t got = read(output_, words, sizeof words);
        if (got <= 0) return;
        said_.append(words, static_cast<std::size_t>(got));
        if (said_.size() > most_said) said_.erase(0, said_.size() - most_said);
    }
}

/// The last line that has words in it.
std::string Process::last_words() const {
    const std::size_t end = said_.find_last_not_of(" \t\r\n");
    if (end == std::string::npos) return "";
    const std::size_t before = said_.find_last_of('\n', end);
    const std::size_t begin = before == std::string::npos ? 0 : before + 1;
    constexpr std::size_t enough = 200;
    return "; it said last: \"" +
           printable(std::string_view(said_).substr(begin, std::min(enough, end + 1 - begin))) + '"';
}

template <class How>
void Process::end(const std::string& how) {
    stop();
    listen();
    throw How(how + last_words());
}

/// The socket is closed: says why.
void Process::explain_end() {
    // It is ending, or has closed the socket and lives on.
    siginfo_t gone{};
    const auto patience = Clock::now() + std::chrono::seconds(1);
    while (waitid(P_PID, static_cast<id_t>(id_), &gone, WEXITED | WNOHANG | WNOWAIT) == 0 &&
           gone.si_pid != id_ && Clock::now() < patience)
        poll(nullptr, 0, 1);
    if (gone.si_pid != id_) end("has closed its socket");
    if (gone.si_code == CLD_EXITED)
        end("has ended itself (exit code " + std::to_string(gone.si_status) + ")");
    const char* const name = sigdescr_np(gone.si_status);
    end("has crashed (signal " + std::to_string(gone.si_status) + (name ? std::string(", ") + name : "") +
        ")");
}

}  // namespace flipside::plugin

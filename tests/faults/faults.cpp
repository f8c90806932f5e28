/// A library for LD_PRELOAD that makes one call of a program fail, as if the disk were full, the file system
/// broken or the memory used up. The program itself is the one that is shipped.
///
///     FLIPSIDE_FAULT=KIND:K     the K-th call of this kind fails, from 1; 0: none
///     FLIPSIDE_FAULT=KIND:K+    and all later ones
///     FLIPSIDE_FAULT_COUNT=FILE how many calls there were of each kind is written there when main() returns
///     FLIPSIDE_FAULT_IN=NAME    only in programs of this name, not in others that they start
///
/// KIND is write, short (a write that writes half), interrupted (a write that a signal broke off), sync,
/// rename, open (to write, or a folder), close, folder (mkdir), input (open to read), read, spawn or memory.
/// Calls count from the beginning of main() to its end: what a program does before that cannot be caught by
/// it.

#include <cerrno>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <iterator>

#include <dlfcn.h>
#include <fcntl.h>
#include <spawn.h>
#include <sys/stat.h>
#include <sys/uio.h>
#include <unistd.h>

namespace {

enum Kind {
    writes,
    shorts,
    interrupts,
    syncs,
    renames,
    opens,
    closes,
    folders,
    inputs,
    reads,
    spawns,
    memory
};
constexpr const char* names[] = {"write", "short",  "interrupted", "sync", "rename", "open",
                                 "close", "folder", "input",       "read", "spawn",  "memory"};
constexpr int kinds = std::size(names);

bool armed = false;
int chosen = -1;
long wanted = 0;
bool for_good = false;
long counts[kinds];

/// Counts a call and says whether it shall fail.
bool fails(Kind kind) {
    if (!armed) return false;
    const long number = ++counts[kind];
    if (kind != chosen || wanted == 0) return false;
    return number == wanted || (for_good && number > wanted);
}

template <class Result>
Result failure(int error, Result result) {
    errno = error;
    return result;
}

/// The function that this library stands before.
template <class Function>
Function* real(Function* /*type*/, const char* name) {
    return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

bool is_of_this_program() {
    const char* const only = std::getenv("FLIPSIDE_FAULT_IN");
    return only == nullptr || std::strcmp(only, program_invocation_short_name) == 0;
}

void arm() {
    const char* const fault = std::getenv("FLIPSIDE_FAULT");
    if (fault == nullptr || !is_of_this_program()) return;
    const char* const colon = std::strchr(fault, ':');
    for (int kind = 0; colon != nullptr && kind < kinds; ++kind)
        if (std::strncmp(fault, names[kind], static_cast<std::size_t>(colon - fault)) == 0 &&
            names[kind][colon - fault] == '\0')
            chosen = kind;
    if (chosen < 0) {
        std::fprintf(stderr, "FLIPSIDE_FAULT=%s names no kind of fault\n", fault);
        std::_Exit(99);
    }
    char* rest = nullptr;
    wanted = std::strtol(colon + 1, &rest, 10);
    for_good = *rest == '+';
    armed = true;
}

void report_counts() {
    armed = false;
    const char* const file = std::getenv("FLIPSIDE_FAULT_COUNT");
    if (file == nullptr || !is_of_this_program()) return;
    std::FILE* const out = std::fopen(file, "w");
    if (out == nullptr) return;
    for (int kind = 0; kind < kinds; ++kind) std::fprintf(out, "%s %ld\n", names[kind], counts[kind]);
    std::fclose(out);
}

int (*real_main)(int, char**, char**);

int main_with_faults(int argc, char** argv, char** environment) {
    arm();
    const int code = real_main(argc, argv, environment);
    report_counts();
    return code;
}

/// Standard streams are not files that must be whole.
bool is_file(int descriptor) {
    return descriptor > STDERR_FILENO;
}

bool opens_to_write(int flags) {
    return (flags & O_ACCMODE) != O_RDONLY || (flags & O_DIRECTORY) != 0;
}

bool open_fails(int flags) {
    return fails(opens_to_write(flags) ? opens : inputs);
}

/// open() and its like: the mode is there where the file may be made.
template <class Open>
int open_with(int flags, std::va_list arguments, Open open) {
    const mode_t mode = (flags & (O_CREAT | O_TMPFILE)) != 0 ? va_arg(arguments, mode_t) : 0;
    if (open_fails(flags)) return failure(ENFILE, -1);
    return open(mode);
}

ssize_t write_all_or_part(int descriptor, const void* data, std::size_t size) {
    static const auto next = real(&::write, "write");
    if (!is_file(descriptor)) return next(descriptor, data, size);
    if (fails(writes)) return failure<ssize_t>(ENOSPC, -1);
    if (fails(interrupts)) return failure<ssize_t>(EINTR, -1);
    return next(descriptor, data, fails(shorts) ? (size + 1) / 2 : size);
}

}  // namespace

extern "C" {

int __libc_start_main(int (*main)(int, char**, char**), int argc, char** argv, void (*init)(), void (*fini)(),
                      void (*loader_fini)(), void* stack_end) {
    real_main = main;
    static const auto next = real(&__libc_start_main, "__libc_start_main");
    return next(main_with_faults, argc, argv, init, fini, loader_fini, stack_end);
}

ssize_t write(int descriptor, const void* data, std::size_t size) {
    return write_all_or_part(descriptor, data, size);
}

ssize_t writev(int descriptor, const iovec* parts, int count) {
    static const auto next = real(&::writev, "writev");
    if (is_file(descriptor) && fails(writes)) return failure<ssize_t>(ENOSPC, -1);
    return next(descriptor, parts, count);
}

ssize_t pwrite(int descriptor, const void* data, std::size_t size, off_t offset) {
    static const auto next = real(&::pwrite, "pwrite");
    if (is_file(descriptor) && fails(writes)) return failure<ssize_t>(ENOSPC, -1);
    return next(descriptor, data, size, offset);
}

std::size_t fwrite(const void* data, std::size_t size, std::size_t count, std::FILE* file) {
    static const auto next = real(&::fwrite, "fwrite");
    if (file != stdout && file != stderr && fails(writes)) return failure<std::size_t>(ENOSPC, 0);
    return next(data, size, count, file);
}

ssize_t read(int descriptor, void* data, std::size_t size) {
    static const auto next = real(&::read, "read");
    if (fails(reads)) return failure<ssize_t>(EIO, -1);
    return next(descriptor, data, size);
}

int fsync(int descriptor) {
    static const auto next = real(&::fsync, "fsync");
    return fails(syncs) ? failure(EIO, -1) : next(descriptor);
}

int fdatasync(int descriptor) {
    static const auto next = real(&::fdatasync, "fdatasync");
    return fails(syncs) ? failure(EIO, -1) : next(descriptor);
}

int rename(const char* from, const char* to) noexcept {
    static const auto next = real(&::rename, "rename");
    return fails(renames) ? failure(EIO, -1) : next(from, to);
}

int renameat(int from_folder, const char* from, int to_folder, const char* to) noexcept {
    static const auto next = real(&::renameat, "renameat");
    return fails(renames) ? failure(EIO, -1) : next(from_folder, from, to_folder, to);
}

int mkdir(const char* path, mode_t mode) noexcept {
    static const auto next = real(&::mkdir, "mkdir");
    return fails(folders) ? failure(ENOSPC, -1) : next(path, mode);
}

int open(const char* path, int flags, ...) {
    static const auto next = real(&::open, "open");
    std::va_list arguments;
    va_start(arguments, flags);
    const int result = open_with(flags, arguments, [&](mode_t mode) { return next(path, flags, mode); });
    va_end(arguments);
    return result;
}

int openat(int folder, const char* path, int flags, ...) {
    static const auto next = real(&::openat, "openat");
    std::va_list arguments;
    va_start(arguments, flags);
    const int result =
        open_with(flags, arguments, [&](mode_t mode) { return next(folder, path, flags, mode); });
    va_end(arguments);
    return result;
}

std::FILE* fopen(const char* path, const char* mode) {
    static const auto next = real(&::fopen, "fopen");
    if (open_fails(mode[0] == 'r' ? O_RDONLY : O_WRONLY)) return failure<std::FILE*>(ENFILE, nullptr);
    return next(path, mode);
}

int close(int descriptor) {
    static const auto next = real(&::close, "close");
    const bool fault = is_file(descriptor) && fails(closes);
    const int result = next(descriptor);
    return fault ? failure(EIO, -1) : result;
}

int pipe2(int* ends, int flags) noexcept {
    static const auto next = real(&::pipe2, "pipe2");
    return fails(spawns) ? failure(EMFILE, -1) : next(ends, flags);
}

int posix_spawnp(pid_t* child, const char* file, const posix_spawn_file_actions_t* actions,
                 const posix_spawnattr_t* attributes, char* const* arguments, char* const* environment) {
    static const auto next = real(&::posix_spawnp, "posix_spawnp");
    return fails(spawns) ? EAGAIN : next(child, file, actions, attributes, arguments, environment);
}

// glibc's own names of the functions below. dlsym() itself asks for memory.
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* old, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);

void* malloc(std::size_t size) {
    return fails(memory) ? failure<void*>(ENOMEM, nullptr) : __libc_malloc(size);
}

void* calloc(std::size_t count, std::size_t size) {
    return fails(memory) ? failure<void*>(ENOMEM, nullptr) : __libc_calloc(count, size);
}

void* realloc(void* old, std::size_t size) {
    return fails(memory) ? failure<void*>(ENOMEM, nullptr) : __libc_realloc(old, size);
}

void* aligned_alloc(std::size_t alignment, std::size_t size) {
    return fails(memory) ? failure<void*>(ENOMEM, nullptr) : __libc_memalign(alignment, size);
}

int posix_memalign(void** result, std::size_t alignment, std::size_t size) noexcept {
    if (fails(memory)) return ENOMEM;
    *result = __libc_memalign(alignment, size);
    return *result == nullptr ? ENOMEM : 0;
}

}  // extern "C"

// On 64-bit systems these are the same functions by other names; programs are compiled with either.
extern "C" int open64(const char* path, int flags, ...) __attribute__((alias("open")));
extern "C" int openat64(int folder, const char* path, int flags, ...) __attribute__((alias("openat")));
extern "C" std::FILE* fopen64(const char* path, const char* mode) __attribute__((alias("fopen")));
extern "C" ssize_t pwrite64(int descriptor, const void* data, std::size_t size, off_t offset)
    __attribute__((alias("pwrite")));

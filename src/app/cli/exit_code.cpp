#include "app/cli/exit_code.hpp"

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <new>

#include "app/cli/output.hpp"
#include "lab/path_error.hpp"
#include "lab/unfinished.hpp"
#include "world/input_error.hpp"

namespace flipside::app {

namespace {

namespace fs = std::filesystem;

int fail(int code, std::string_view message) {
    say(message);
    return code;
}

/// Without a word that needs memory.
int fail_without_memory() {
    static_cast<void>(std::fputs("flipside: out of memory\n", stderr));
    return 1;
}

int code_of(const std::function<int()>& action) {
    try {
        const int code = action();
        finish_output();
        return code;
    } catch (const std::bad_alloc&) {
        return fail_without_memory();
    } catch (const InputError& error) {
        return fail(2, error.what());
    } catch (const fs::filesystem_error& error) {
        return fail(lab::is_bad_path(error.code()) ? 2 : 1,
                    error.path1().string() + ": cannot be used (" + error.code().message() + ")");
    } catch (const std::exception& error) {
        return fail(1, error.what());
    }
}

/// Destructors of libraries may ask for memory (nlohmann-json's do), and nothing can catch what they throw.
[[noreturn]] void end_at_once() {
    lab::abandon_unfinished();
    try {
        if (const auto error = std::current_exception()) std::rethrow_exception(error);
    } catch (const std::bad_alloc&) {
        std::_Exit(fail_without_memory());
    } catch (...) {
        static_cast<void>(std::fputs("flipside: an error that nothing catches\n", stderr));
    }
    std::abort();
}

}  // namespace

int exit_code_of(const std::function<int()>& action) noexcept {
    std::set_terminate(end_at_once);
    try {
        return code_of(action);
    } catch (...) {  // words for the error took more memory than there is
        return fail_without_memory();
    }
}

}  // namespace flipside::app

#include "app/cli/exit_code.hpp"

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <new>

#include "app/cli/output.hpp"
#include "lab/files/path_error.hpp"
#include "lab/process/unfinished.hpp"
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

/// In place of an exception: destructors and iterators of libraries may ask for memory where nothing can be
/// thrown (nlohmann-json's and std::filesystem's do).
[[noreturn]] void end_without_memory() {
    lab::abandon_unfinished();
    std::_Exit(fail_without_memory());
}

int code_of(const std::function<int()>& action) {
    try {
        const int code = action();
        finish_output();
        return code;
    } catch (const std::bad_alloc&) {  // of a size that is no size
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

}  // namespace

int exit_code_of(const std::function<int()>& action) noexcept {
    std::set_new_handler(end_without_memory);
    return code_of(action);
}

}  // namespace flipside::app

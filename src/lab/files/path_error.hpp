#pragma once
/// Errors of the file system: InputError for a path that is wrong, Failure for all others.

#include <filesystem>
#include <string>
#include <system_error>

namespace flipside::lab {

/// Whether the path itself is wrong: too long, not permitted, a link to itself, in a folder that is missing
/// or read-only, a folder where a file is meant or a file where a folder is. All else (a full disk) is not
/// the user's fault.
[[nodiscard]] bool is_bad_path(std::error_code why);

/// "PATH: PROBLEM (why)": InputError where is_bad_path(why), else Failure.
[[noreturn]] void throw_path_error(const std::filesystem::path& path, const std::string& problem,
                                   std::error_code why);

}  // namespace flipside::lab

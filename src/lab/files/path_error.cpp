#include "lab/files/path_error.hpp"

#include <algorithm>

#include "lab/process/failure.hpp"
#include "world/input_error.hpp"

namespace flipside::lab {

bool is_bad_path(std::error_code why) {
    using enum std::errc;
    constexpr std::errc of_paths[] = {
        filename_too_long,         permission_denied, operation_not_permitted, too_many_symbolic_link_levels,
        no_such_file_or_directory, not_a_directory,   is_a_directory,          read_only_file_system};
    return std::ranges::any_of(of_paths, [&](std::errc one) { return why == one; });
}

void throw_path_error(const std::filesystem::path& path, const std::string& problem, std::error_code why) {
    const std::string message = path.string() + ": " + problem + " (" + why.message() + ")";
    if (is_bad_path(why)) throw InputError(message);
    throw Failure(message);
}

}  // namespace flipside::lab

#include "lab/files/path_error.hpp"

#include "lab/process/failure.hpp"
#include "world/input_error.hpp"

namespace flipside::lab {

bool is_bad_path(std::error_code why) {
    return why == std::errc::filename_too_long || why == std::errc::permission_denied ||
           why == std::errc::operation_not_permitted || why == std::errc::too_many_symbolic_link_levels;
}

void throw_path_error(const std::filesystem::path& path, const std::string& problem, std::error_code why) {
    const std::string message = path.string() + ": " + problem + " (" + why.message() + ")";
    if (is_bad_path(why)) throw InputError(message);
    throw Failure(message);
}

}  // namespace flipside::lab

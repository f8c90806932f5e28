#include "app/cli/distinct_files.hpp"

#include <optional>
#include <system_error>
#include <tuple>

#include <sys/stat.h>
#include <unistd.h>

#include "lab/contenders/engines.hpp"
#include "world/input_error.hpp"

namespace flipside::app {

namespace fs = std::filesystem;

namespace {

/// Of a file that is there: device and inode. Of one that is not: those of its folder, and its name.
using Identity = std::tuple<dev_t, ino_t, std::string>;

std::optional<Identity> identity_of_existing(const fs::path& path, const std::string& name) {
    struct stat found {};
    if (stat(path.c_str(), &found) != 0) return std::nullopt;
    return Identity(found.st_dev, found.st_ino, name);
}

/// The file that a symbolic link to nothing stands for.
fs::path end_of_links(fs::path path) {
    constexpr int most_links = 40;  // as Linux follows
    std::error_code error;
    for (int i = 0; i < most_links && fs::is_symlink(fs::symlink_status(path, error)); ++i) {
        const fs::path target = fs::read_symlink(path, error);
        if (error) break;
        path = path.parent_path() / target;  // an absolute target replaces all
    }
    return path;
}

/// Nothing where the path leads nowhere; what opens it says why.
std::optional<Identity> identity_of(const fs::path& path) {
    if (auto identity = identity_of_existing(path, "")) return identity;
    const fs::path end = end_of_links(path);
    const fs::path folder = end.parent_path();
    return identity_of_existing(folder.empty() ? "." : folder, end.filename().string());
}

std::optional<Identity> stdout_file() {
    struct stat found {};
    if (fstat(STDOUT_FILENO, &found) != 0 || !S_ISREG(found.st_mode)) return std::nullopt;
    return Identity(found.st_dev, found.st_ino, "");
}

std::string quoted(const NamedFile& file) {
    return file.what + " '" + file.path.string() + "'";
}

}  // namespace

void require_distinct(const FilesOfCommand& files) {
    std::vector<NamedFile> inputs = files.inputs;
    for (const Engine* engine : lab::engines()) inputs.push_back({"the library", engine->file});
    const auto null = identity_of("/dev/null"), printed = files.prints ? stdout_file() : std::nullopt;
    for (const NamedFile& output : files.outputs) {
        if (output.path.empty()) continue;
        const auto identity = identity_of(output.path);
        if (!identity || identity == null) continue;
        const std::string allowed = "; allowed are different files";
        for (const NamedFile& input : inputs)
            if (!input.path.empty() && identity_of(input.path) == identity)
                throw InputError(quoted(output) + " is " + quoted(input) + ", which is read" + allowed);
        for (const NamedFile& other : files.outputs) {
            if (&other == &output) break;
            if (!other.path.empty() && identity_of(other.path) == identity)
                throw InputError(quoted(output) + " is " + quoted(other) + ", which is written too" +
                                 allowed);
        }
        if (identity == printed)
            throw InputError(quoted(output) + " is the file that stdout goes to" + allowed);
    }
}

}  // namespace flipside::app

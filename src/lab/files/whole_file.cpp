#include "lab/files/whole_file.hpp"

#include <cerrno>
#include <climits>
#include <cstdio>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "lab/files/path_error.hpp"

namespace flipside::lab {

namespace fs = std::filesystem;

namespace {

/// Links there lead to what is open, not to files.
bool is_of_the_system(const fs::path& path) {
    const std::string name = fs::absolute(path).lexically_normal().string();
    return name.starts_with("/dev/") || name.starts_with("/proc/");
}

/// Where links lead, through as many as the system would follow.
fs::path followed(fs::path path) {
    constexpr int most_links = 40;
    std::error_code error;
    for (int link = 0; link < most_links; ++link) {
        if (!fs::is_symlink(fs::symlink_status(path, error)) || is_of_the_system(path)) break;
        path = path.parent_path() / fs::read_symlink(path, error);
    }
    return path;
}

/// Renaming would put a plain file where a link, a pipe or a device was.
bool is_plain_or_new(const fs::path& path) {
    std::error_code error;
    const fs::file_type type = fs::symlink_status(path, error).type();
    return type == fs::file_type::regular || type == fs::file_type::not_found;
}

int open_to_write(const fs::path& path) {
    constexpr mode_t as_umask_allows = 0666;
    return open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, as_umask_allows);
}

/// Gives the new file the permissions of the one that it will replace. Returns an error of the system, 0 for
/// none; a file that may not be written may not be replaced either.
int keep_permissions(const fs::path& place, int descriptor) {
    struct stat replaced {};
    if (stat(place.c_str(), &replaced) != 0) return errno == ENOENT ? 0 : errno;
    constexpr mode_t permissions = 07777;
    const bool kept =
        access(place.c_str(), W_OK) == 0 && fchmod(descriptor, replaced.st_mode & permissions) == 0;
    return kept ? 0 : errno;
}

/// Without this a crash of the system may undo the renaming.
void sync_folder(const fs::path& target, const fs::path& place) {
    const fs::path parent = place.parent_path();
    const int folder = open(parent.empty() ? "." : parent.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    const int error = folder < 0 || fsync(folder) != 0 ? errno : 0;
    if (folder >= 0) close(folder);
    // Some file systems cannot sync a folder, and one that may be written into need not be readable.
    if (error != 0 && error != EINVAL && error != EACCES) fail_to_write(target, error);
}

fs::path temporary_name(const fs::path& place) {
    static unsigned count = 0;
    const std::string name = ".flipside-" + std::to_string(getpid()) + "-" + std::to_string(count++);
    return place.parent_path() / (name + ".part");
}

}  // namespace

TemporaryFile::TemporaryFile(const fs::path& place) : path_(temporary_name(place)), unfinished_(path_) {}

TemporaryFile::~TemporaryFile() {
    unlink(path_.c_str());
}

WholeFile::WholeFile(fs::path target)
    : target_(std::move(target)),
      place_(followed(target_)),
      is_direct_(!is_plain_or_new(place_)),
      temporary_(place_),
      descriptor_(open_to_write(is_direct_ ? place_ : temporary_.path())),
      buffer_(descriptor_, target_),
      out_(&buffer_) {
    if (descriptor_ < 0) fail_to_write(target_, errno);
    // The temporary file's name is shorter, so this would come out at the end only.
    if (place_.filename().native().size() > NAME_MAX) fail_to_write(target_, ENAMETOOLONG);
    if (const int error = is_direct_ ? 0 : keep_permissions(place_, descriptor_); error != 0)
        fail_to_write(target_, error);
    out_.exceptions(std::ios::badbit);
}

WholeFile::~WholeFile() {
    if (descriptor_ >= 0) close(descriptor_);
}

void WholeFile::finish() {
    out_.flush();
    if (!is_direct_ && fsync(descriptor_) != 0) fail_to_write(target_, errno);
    if (close(std::exchange(descriptor_, -1)) != 0) fail_to_write(target_, errno);
    if (is_direct_) return;
    if (rename(temporary_.path().c_str(), place_.c_str()) != 0) fail_to_write(target_, errno);
    sync_folder(target_, place_);
}

void make_folder(const fs::path& folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) throw_path_error(folder, "cannot be made", error);
}

void write_whole_file(const fs::path& target, std::string_view text) {
    WholeFile file(target);
    file.out() << text;
    file.finish();
}

}  // namespace flipside::lab

#include "lab/whole_file.hpp"

#include <cerrno>
#include <cstdio>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

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

/// Without this a crash of the system may undo the renaming.
void sync_folder(const fs::path& target, const fs::path& place) {
    const fs::path parent = place.parent_path();
    const int folder = open(parent.empty() ? "." : parent.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    const int error = folder < 0 || fsync(folder) != 0 ? errno : 0;
    if (folder >= 0) close(folder);
    // Some file systems cannot sync a folder, and one that may be written into need not be readable.
    if (error != 0 && error != EINVAL && error != EACCES) fail_to_write(target, error);
}

}  // namespace

WholeFile::Draft::Draft(const fs::path& target, const fs::path& place)
    : path(place), is_temporary(is_plain_or_new(place)) {
    if (is_temporary) path += "." + std::to_string(getpid()) + ".part";
    descriptor = open_to_write(path);
    if (descriptor < 0) fail_to_write(target, errno);
}

WholeFile::Draft::~Draft() {
    close();
    if (is_temporary) unlink(path.c_str());
}

int WholeFile::Draft::close() {
    if (descriptor < 0) return 0;
    const int result = ::close(std::exchange(descriptor, -1));
    return result == 0 ? 0 : errno;
}

WholeFile::WholeFile(fs::path target)
    : target_(std::move(target)),
      place_(followed(target_)),
      draft_(target_, place_),
      buffer_(draft_.descriptor, target_),
      out_(&buffer_) {
    out_.exceptions(std::ios::badbit);
}

void WholeFile::finish() {
    out_.flush();
    const bool is_direct = !draft_.is_temporary;
    if (!is_direct && fsync(draft_.descriptor) != 0) fail_to_write(target_, errno);
    if (const int error = draft_.close(); error != 0) fail_to_write(target_, error);
    if (is_direct) return;
    if (rename(draft_.path.c_str(), place_.c_str()) != 0) fail_to_write(target_, errno);
    draft_.is_temporary = false;
    sync_folder(target_, place_);
}

void write_whole_file(const fs::path& target, std::string_view text) {
    WholeFile file(target);
    file.out() << text;
    file.finish();
}

}  // namespace flipside::lab

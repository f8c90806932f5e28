#include "lab/whole_file.hpp"

#include <cerrno>
#include <system_error>

#include <unistd.h>

#include "lab/failure.hpp"

namespace flipside::lab {

namespace fs = std::filesystem;

namespace {

/// Renaming would put a plain file where a link, a pipe or a device was.
bool is_plain_or_new(const fs::path& path) {
    const fs::file_type type = fs::symlink_status(path).type();
    return type == fs::file_type::regular || type == fs::file_type::not_found;
}

[[noreturn]] void fail(const fs::path& target) {
    const std::string why = std::generic_category().message(errno);
    throw Failure(target.string() + ": cannot be written (" + why + ")");
}

}  // namespace

WholeFile::WholeFile(fs::path target) : target_(std::move(target)), written_(target_) {
    errno = EISDIR;
    if (fs::is_directory(target_)) fail(target_);
    if (is_plain_or_new(target_)) written_ += "." + std::to_string(getpid()) + ".part";
    out_.open(written_, std::ios::binary);
    if (!out_) fail(target_);
}

WholeFile::~WholeFile() {
    std::error_code none;
    if (written_ != target_) fs::remove(written_, none);
}

void WholeFile::finish() {
    out_.close();
    if (!out_) fail(target_);
    if (written_ == target_) return;
    std::error_code error;
    fs::rename(written_, target_, error);
    if (error) throw Failure(target_.string() + ": cannot be written (" + error.message() + ")");
    written_ = target_;
}

void write_whole_file(const fs::path& target, std::string_view text) {
    WholeFile file(target);
    file.out() << text;
    file.finish();
}

}  // namespace flipside::lab

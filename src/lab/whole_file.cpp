#include "lab/whole_file.hpp"

#include <cerrno>
#include <system_error>

#include <unistd.h>

#include "lab/failure.hpp"

namespace flipside::lab {

namespace fs = std::filesystem;

namespace {

bool is_special(const fs::path& path) {
    std::error_code none;
    return fs::exists(path, none) && !fs::is_regular_file(path, none) && !fs::is_directory(path, none);
}

[[noreturn]] void fail(const fs::path& target) {
    const std::string why = std::generic_category().message(errno);
    throw Failure(target.string() + ": cannot be written (" + why + ")");
}

}  // namespace

WholeFile::WholeFile(fs::path target) : target_(std::move(target)), written_(target_) {
    errno = EISDIR;
    if (fs::is_directory(target_)) fail(target_);
    if (!is_special(target_)) written_ += "." + std::to_string(getpid()) + ".part";
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

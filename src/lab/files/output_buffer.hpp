#pragma once
/// A stream buffer that writes to an open file. Unlike std::filebuf it says why a write failed.

#include <array>
#include <filesystem>
#include <streambuf>

namespace flipside::lab {

/// Throws Failure: "TARGET: cannot be written (what the system says to this errno)".
[[noreturn]] void fail_to_write(const std::filesystem::path& target, int error);

/// Its functions throw Failure when not everything could be written; what was not written then is dropped.
class OutputBuffer final : public std::streambuf {
  public:
    /// Owns neither the descriptor nor the name, which is for messages.
    OutputBuffer(int descriptor, const std::filesystem::path& target)
        : descriptor_(descriptor), target_(target) {
        clear();
    }

  protected:
    int_type overflow(int_type c) override;
    std::streamsize xsputn(const char* text, std::streamsize size) override;
    int sync() override;

  private:
    void clear() { setp(buffer_.data(), buffer_.data() + buffer_.size()); }
    void write_all(const char* text, std::size_t size) const;

    int descriptor_;
    const std::filesystem::path& target_;
    std::array<char, 1U << 16U> buffer_{};
};

}  // namespace flipside::lab

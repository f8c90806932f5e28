#include "lab/files/output_buffer.hpp"

#include <cerrno>
#include <system_error>

#include <unistd.h>

#include "lab/files/path_error.hpp"

namespace flipside::lab {

void fail_to_write(const std::filesystem::path& target, int error) {
    throw_path_error(target, "cannot be written", std::error_code(error, std::generic_category()));
}

void OutputBuffer::write_all(const char* text, std::size_t size) const {
    while (size > 0) {
        const ssize_t written = ::write(descriptor_, text, size);
        if (written < 0 && errno == EINTR) continue;
        // A write of nothing without an error does not occur on a file; it must not become an endless loop.
        if (written <= 0) fail_to_write(target_, written < 0 ? errno : EIO);
        text += written;
        size -= static_cast<std::size_t>(written);
    }
}

int OutputBuffer::sync() {
    const char* const text = pbase();
    const auto waiting = static_cast<std::size_t>(pptr() - text);
    clear();  // so that a write that failed is not tried again
    write_all(text, waiting);
    return 0;
}

OutputBuffer::int_type OutputBuffer::overflow(int_type c) {
    sync();
    if (traits_type::eq_int_type(c, traits_type::eof())) return traits_type::not_eof(c);
    return sputc(traits_type::to_char_type(c));
}

std::streamsize OutputBuffer::xsputn(const char* text, std::streamsize size) {
    if (size < epptr() - pptr()) return std::streambuf::xsputn(text, size);
    sync();
    write_all(text, static_cast<std::size_t>(size));
    return size;
}

}  // namespace flipside::lab

#pragma once
/// Values in a row of bytes, as they go from one process to the other. Both are the same program, so their
/// layout is the same too.

#include <cstdint>
#include <cstring>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace flipside::plugin {

using Bytes = std::vector<std::byte>;

/// Bytes that are not what was expected.
struct Malformed : std::runtime_error {
    using std::runtime_error::runtime_error;
};

class Writer {
  public:
    explicit Writer(Bytes& out) : out_(out) { out_.clear(); }

    template <class T>
    requires std::is_trivially_copyable_v<T>
    void value(const T& value) { raw(&value, sizeof value); }
    template <class T>
    requires std::is_trivially_copyable_v<T>
    void array(std::span<const T> values) {
        value(static_cast<std::uint64_t>(values.size()));
        if (!values.empty()) raw(values.data(), values.size_bytes());
    }
    void text(std::string_view words) { array(std::span(words.data(), words.size())); }

  private:
    void raw(const void* from, std::size_t size) {
        const std::size_t at = out_.size();
        out_.resize(at + size);
        std::memcpy(out_.data() + at, from, size);
    }

    Bytes& out_;
};

/// Throws Malformed where there is less than is asked for.
class Reader {
  public:
    explicit Reader(std::span<const std::byte> in) : in_(in) {}

    template <class T>
    requires std::is_trivially_copyable_v<T>
    [[nodiscard]] T value() {
        T value{};
        raw(&value, sizeof value);
        return value;
    }
    template <class T>
    requires std::is_trivially_copyable_v<T>
    void array(std::vector<T>& values) {
        values.resize(count(sizeof(T)));
        if (!values.empty()) raw(values.data(), values.size() * sizeof(T));
    }
    [[nodiscard]] std::string text() {
        std::string words(count(1), '\0');
        if (!words.empty()) raw(words.data(), words.size());
        return words;
    }
    /// Throws Malformed where something is left.
    void finish() const {
        if (!in_.empty()) throw Malformed("there is more than belongs there");
    }

  private:
    [[nodiscard]] std::size_t count(std::size_t size) {
        const auto n = value<std::uint64_t>();
        if (n > in_.size() / size) throw Malformed("there is less than belongs there");
        return static_cast<std::size_t>(n);
    }
    void raw(void* to, std::size_t size) {
        if (size > in_.size()) throw Malformed("there is less than belongs there");
        std::memcpy(to, in_.data(), size);
        in_ = in_.subspan(size);
    }

    std::span<const std::byte> in_;
};

}  // namespace flipside::plugin

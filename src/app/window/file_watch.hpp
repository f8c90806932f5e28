#pragma once
/// Whether a file has been written since the last look.

#include <cstdint>
#include <filesystem>
#include <optional>

namespace flipside::app {

class FileWatch {
  public:
    /// From now on. An empty path: nothing.
    void watch(const std::filesystem::path& file) {
        file_ = file;
        seen_ = look();
    }
    /// False while there is no such file: it is being replaced.
    [[nodiscard]] bool changed() {
        const auto now = look();
        if (!now || now == seen_) return false;
        seen_ = now;
        return true;
    }

  private:
    struct Mark {
        std::filesystem::file_time_type time;
        std::uintmax_t size = 0;
        friend bool operator==(const Mark&, const Mark&) = default;
    };
    [[nodiscard]] std::optional<Mark> look() const {
        std::error_code no_time, no_size;
        const Mark mark{last_write_time(file_, no_time), file_size(file_, no_size)};
        if (no_time || no_size) return std::nullopt;
        return mark;
    }

    std::filesystem::path file_;
    std::optional<Mark> seen_;
};

}  // namespace flipside::app

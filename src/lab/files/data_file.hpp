#pragma once
/// Files of measurements that a later run reads back. Their last line tells whether they are whole,
/// unchanged, and what is asked for:
///
///     # flipside-data/1 of ORIGIN: ROWS rows, xxh3 CHECKSUM
///
/// ORIGIN says what the file holds, see origin_of(); ROWS counts the lines before this one; CHECKSUM is XXH3
/// (Y. Collet, 64 bits, hexadecimal) of everything before its own name.

#include <filesystem>
#include <functional>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

#include "world/input_error.hpp"

namespace flipside::lab {

/// Told in one sentence what a long run does that was not asked for.
using Notice = std::function<void(const std::string& sentence)>;

/// XXH3 of the text, 16 hexadecimal digits.
[[nodiscard]] std::string checksum(std::string_view text);

/// "KIND-CHECKSUM", of all the texts that decide what a file of this kind holds (plan, scene, number of the
/// work unit, version): with other texts the file is another one.
[[nodiscard]] std::string origin_of(std::string_view kind, std::initializer_list<std::string_view> texts);

/// A whole file (whole_file.hpp) of this text, which ends with \n or is empty, and the last line.
void write_data_file(const std::filesystem::path& file, const std::string& origin, std::string_view text);

/// The text again. Throws InputError where it is not, to the bit, what write_data_file wrote for this origin.
[[nodiscard]] std::string read_data_file(const std::filesystem::path& file, const std::string& origin);

/// Whether something is there. Throws InputError for what a file could not replace (a folder, a pipe).
[[nodiscard]] bool is_there(const std::filesystem::path& file);

/// What `read` makes of a file, or nothing where there is none and where `read` throws InputError: then the
/// file is damaged, and the notice says so and `what_now`.
template <class Read>
[[nodiscard]] auto read_back(const std::filesystem::path& file, const Notice& notice, Read read,
                             const char* what_now) -> std::optional<decltype(read())> {
    if (!is_there(file)) return std::nullopt;
    try {
        return read();
    } catch (const InputError& error) {
        notice(std::string(error.what()) + "; " + what_now);
        return std::nullopt;
    }
}

}  // namespace flipside::lab

#include "lab/files/data_file.hpp"

#include <algorithm>
#include <cstdio>

#include <xxhash.h>

#include "lab/files/whole_file.hpp"
#include "world/json_file.hpp"

namespace flipside::lab {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view format = "# flipside-data/1 ";

std::size_t rows_in(std::string_view text) {
    return static_cast<std::size_t>(std::ranges::count(text, '\n'));
}

/// The last line up to its checksum.
std::string promise(std::string_view origin, std::string_view text) {
    return std::string(format) + "of " + std::string(origin) + ": " + std::to_string(rows_in(text)) + " rows";
}

std::string last_line(std::string_view origin, std::string_view text) {
    const std::string said = promise(origin, text);
    return said + ", xxh3 " + checksum(std::string(text) + said) + "\n";
}

/// What is wrong with a file of this origin, whose text and last line are not what they should be.
std::string problem(std::string_view text, std::string_view last, std::string_view origin) {
    if (text.empty() && last.empty()) return "is empty";
    constexpr std::string_view any_format = "# flipside-data/";
    if (!last.starts_with(any_format) || !last.ends_with('\n'))
        return "does not end with a line that says it is whole: it was cut, or an older version wrote it";
    if (!last.starts_with(format)) return "is of another version of this program";
    if (!last.starts_with(std::string(format) + "of " + std::string(origin) + ":"))
        return "holds something else than what is asked for: another sweep, scene, seed or build";
    if (!last.starts_with(promise(origin, text) + ","))
        return "has " + std::to_string(rows_in(text)) + " rows, and its last line says another number";
    return "is damaged: it does not have the checksum that its last line says";
}

}  // namespace

std::string checksum(std::string_view text) {
    char digits[17];
    std::snprintf(digits, sizeof digits, "%016llx",
                  static_cast<unsigned long long>(XXH3_64bits(text.data(), text.size())));
    return digits;
}

std::string origin_of(std::string_view kind, std::initializer_list<std::string_view> texts) {
    std::string all;
    for (const std::string_view text : texts)
        (all += checksum(text)) += '/';  // so that no two lists are alike
    return std::string(kind) + '-' + checksum(all);
}

void write_data_file(const fs::path& file, const std::string& origin, std::string_view text) {
    write_whole_file(file, std::string(text) + last_line(origin, text));
}

std::string read_data_file(const fs::path& file, const std::string& origin) {
    std::string all = read_file(file);
    // The last line begins after the last line end but one.
    const std::size_t before = all.size() < 2 ? std::string::npos : all.rfind('\n', all.size() - 2);
    const std::size_t end = before == std::string::npos ? 0 : before + 1;
    const std::string_view text(all.data(), end), last(all.data() + end, all.size() - end);
    if (last != last_line(origin, text)) throw InputError(file.string(), "", problem(text, last, origin));
    all.resize(end);
    return all;
}

bool is_there(const fs::path& file) {
    std::error_code error;
    const fs::file_type type = fs::symlink_status(file, error).type();
    if (type == fs::file_type::not_found) return false;
    if (type == fs::file_type::regular) return true;
    const fs::file_type behind = fs::status(file, error).type();  // of a link
    if (behind == fs::file_type::regular || behind == fs::file_type::not_found) return true;
    throw InputError(file.string(), "", "is no file; allowed is a file, or nothing at all");
}

}  // namespace flipside::lab

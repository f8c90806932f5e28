#include "damages.hpp"

#include <fstream>
#include <stdexcept>

#include <sys/stat.h>
#include <unistd.h>

#include "folders.hpp"

namespace flipside::faults {

namespace fs = std::filesystem;

namespace {

using Edit = std::function<std::string(std::string)>;

Damage edited(const char* name, const Edit& edit) {
    return {name, [=](const fs::path& file) {
                const std::string text = text_of(file), other = edit(text);
                if (other == text) throw std::logic_error(std::string(name) + " leaves the file as it is");
                std::ofstream(file, std::ios::binary) << other;
            }};
}

/// In place of the file.
Damage replaced(const char* name, const std::function<void(const fs::path&)>& make, bool is_obstacle) {
    return {name,
            [=](const fs::path& file) {
                fs::remove(file);
                make(file);
            },
            is_obstacle};
}

std::string flipped(std::string text, std::size_t at) {
    text.at(at) = static_cast<char>(text.at(at) ^ 1);
    return text;
}

/// With the line ends kept. A file of a single line counts as two: that and its last line.
std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines(1);
    for (const char c : text) {
        lines.back() += c;
        if (c == '\n') lines.emplace_back();
    }
    lines.pop_back();
    return lines;
}

std::string joined(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines) text += line;
    return text;
}

std::string replaced_once(std::string text, const std::string& what, const std::string& with) {
    const std::size_t at = text.rfind(what);
    if (at == std::string::npos) throw std::logic_error("there is no " + what);
    return text.replace(at, what.size(), with);
}

/// The first digit, which is that of a number or of a name.
std::size_t digit_in(const std::string& text) {
    return text.find_first_of("0123456789", text.find_first_of(":\n"));
}

std::vector<Damage> cuts() {
    return {
        edited("empty", [](const std::string&) { return ""; }),
        edited("cut after one byte", [](const std::string& text) { return text.substr(0, 1); }),
        edited("cut in the middle", [](const std::string& text) { return text.substr(0, text.size() / 2); }),
        edited("cut before its last line",
               [](const std::string& text) { return text.substr(0, text.rfind("# flipside-data")); }),
        edited("cut in its last line",
               [](const std::string& text) { return text.substr(0, text.size() - 9); }),
        edited("without its last byte",
               [](const std::string& text) { return text.substr(0, text.size() - 1); }),
        edited("all NUL", [](const std::string& text) { return std::string(text.size(), '\0'); }),
        edited("a page of NUL",
               [](std::string text) {
                   const std::size_t from = text.size() / 3,
                                     size = std::min<std::size_t>(4096, text.size() / 3);
                   return text.replace(from, size, size, '\0');
               }),
        edited("NUL at the end", [](const std::string& text) { return text + std::string(100, '\0'); })};
}

std::vector<Damage> changes() {
    return {
        edited("a bit of the first byte", [](const std::string& text) { return flipped(text, 0); }),
        edited("a bit in the middle", [](const std::string& text) { return flipped(text, text.size() / 2); }),
        edited("a bit of the checksum",
               [](const std::string& text) { return flipped(text, text.size() - 3); }),
        edited("a bit of the origin",
               [](const std::string& text) { return flipped(text, text.rfind(" of ") + 6); }),
        edited("a row twice",
               [](const std::string& text) {
                   auto lines = lines_of(text);
                   lines.insert(lines.begin(), lines.front());
                   return joined(lines);
               }),
        edited("a row less",
               [](const std::string& text) {
                   auto lines = lines_of(text);
                   lines.erase(lines.end() - 2);
                   return joined(lines);
               }),
        edited("rows in another order",
               [](const std::string& text) {
                   auto lines = lines_of(text);
                   std::swap(lines.front(), *(lines.end() - 2 - (lines.size() == 2 ? -1 : 0)));
                   return joined(lines);
               }),
        edited("NaN", [](std::string text) { return text.replace(digit_in(text), 1, "nan"); }),
        edited("infinite", [](std::string text) { return text.replace(digit_in(text), 1, "inf"); }),
        edited("negative", [](std::string text) { return text.insert(digit_in(text), "-"); }),
        edited("far out of range",
               [](std::string text) { return text.insert(digit_in(text), "99999999999"); }),
        edited("1e300", [](std::string text) { return text.replace(digit_in(text), 1, "1e300"); }),
        edited("lines end with CR LF",
               [](const std::string& text) {
                   std::string other;
                   for (const char c : text) other += c == '\n' ? std::string("\r\n") : std::string(1, c);
                   return other;
               }),
        edited("begins with a BOM", [](const std::string& text) { return "\xef\xbb\xbf" + text; }),
        edited("another number of rows",
               [](const std::string& text) { return replaced_once(text, " rows", "1 rows"); }),
        edited("another checksum",
               [](const std::string& text) {
                   return text.substr(0, text.rfind("xxh3 ")) + "xxh3 0123456789abcdef\n";
               }),
        edited("another version",
               [](const std::string& text) {
                   return replaced_once(text, "flipside-data/1", "flipside-data/2");
               }),
        edited("something behind its end", [](const std::string& text) { return text + "more\n"; }),
        edited("twice", [](const std::string& text) { return text + text; }),
        edited("another program's",
               [](const std::string&) { return "{\"name\": \"\\u001b[2J\", \"a\": 1}\n"; }),
        edited("huge", [](const std::string& text) { return text + std::string((64U << 20U), '\n'); })};
}

}  // namespace

std::vector<Damage> damages(const fs::path& foreign) {
    std::vector<Damage> all = cuts();
    for (Damage& damage : changes()) all.push_back(std::move(damage));
    all.push_back(edited("foreign", [foreign](const std::string&) { return text_of(foreign); }));
    all.push_back(replaced(
        "a link to nothing", [](const fs::path& file) { fs::create_symlink("../../nothing", file); }, false));
    if (geteuid() != 0)  // root reads everything
        all.push_back(
            {"not to be read", [](const fs::path& file) { fs::permissions(file, fs::perms::none); }});
    all.push_back(replaced(
        "a link to itself", [](const fs::path& file) { fs::create_symlink(file.filename(), file); }, true));
    all.push_back(replaced(
        "a folder", [](const fs::path& file) { fs::create_directory(file); }, true));
    all.push_back(replaced(
        "a pipe", [](const fs::path& file) { mkfifo(file.c_str(), 0600); }, true));
    all.push_back(replaced(
        "a device", [](const fs::path& file) { fs::create_symlink("/dev/zero", file); }, true));
    return all;
}

}  // namespace flipside::faults

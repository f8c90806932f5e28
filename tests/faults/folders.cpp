#include "folders.hpp"

#include <algorithm>
#include <fstream>
#include <regex>
#include <sstream>

#include "lab/files/csv_table.hpp"
#include "world/input_error.hpp"

namespace flipside::faults {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view last_line = "# flipside-data/";

/// Without columns of measured times, and without the last line, whose checksum is of those too.
std::string without_times(const std::string& csv) {
    std::string text;
    try {
        const lab::CsvTable table("test", csv);
        for (std::size_t row = 0; row < table.rows(); ++row) {
            for (const std::string& column : table.columns())
                if (!column.starts_with("cpu_")) text += table.text(row, column) + ',';
            text += '\n';
        }
    } catch (const InputError&) {
        return csv;  // half a table
    }
    return text;
}

/// What is drawn of measured times differs from report to report, and with it the page; what is there must
/// have its end.
bool is_of_times(const std::string& name) {
    for (const char* timed : {"figures/work-", "figures/case-", "figure-work-", "figure-case-", "growth-time",
                              "figures/regimes", "figure-regimes", "pairs-time", "index.html"})
        if (name.find(timed) != std::string::npos) return true;
    return false;
}

std::string end_of(const std::string& name, const std::string& text) {
    if (name.ends_with(".csv")) return text.ends_with('\n') ? "..." : "has no end";
    for (const auto& [extension, end] :
         {std::pair(".html", "</html>"), {".svg", "</svg>"}, {".png", "IEND"}, {".gp", "unset output"}})
        if (name.ends_with(extension))
            return text.find(end, text.size() < 20 ? 0 : text.size() - 20) != std::string::npos
                       ? "..."
                       : "has no end";
    return text;
}

std::string normal(const std::string& name, const std::string& text) {
    static const std::regex times("\"(step_seconds|cpu_seconds)\": [-+.0-9e]+");
    std::string whole = text;
    if (const std::size_t at = text.rfind(last_line); at != std::string::npos && text.ends_with('\n')) {
        whole.resize(at);
        whole += name.ends_with(".csv") ? "" : "# with its last line";
    }
    if (is_of_times(name)) return end_of(name, whole);
    if (name.ends_with(".json")) return std::regex_replace(whole, times, "");
    if (!name.ends_with(".csv") || whole.empty() || !whole.ends_with('\n')) return whole;
    return without_times(whole);
}

}  // namespace

std::string text_of(const fs::path& file) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
}

Contents contents_of(const fs::path& folder) {
    Contents contents;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        const std::string name = entry.path().lexically_relative(folder).string();
        if (entry.is_regular_file()) contents[name] = normal(name, text_of(entry.path()));
    }
    return contents;
}

std::string half_files(const Contents& found, const Contents& before, const Contents& after) {
    for (const auto& [name, text] : found) {
        const auto old = before.find(name), made = after.find(name);
        if (old == before.end() && made == after.end()) return name + " was left behind";
        const bool is_old = old != before.end() && old->second == text;
        const bool is_new = made != after.end() && made->second == text;
        if (!is_old && !is_new) return name + " is neither what it was nor what it should be:\n" + text;
    }
    return "";
}

std::string unclear_end(const Ended& ended, bool may_refuse) {
    if (ended.code == 0) return "";
    const bool is_allowed = ended.code == 1 || (may_refuse && ended.code == 2);
    // What cannot be read back may have been named before.
    const bool is_line = (may_refuse || std::ranges::count(ended.err, '\n') == 1) &&
                         ended.err.ends_with('\n') && ended.err.starts_with("flipside: ") &&
                         ended.err.size() > 15;
    return is_allowed && is_line ? "" : "code " + std::to_string(ended.code) + ", said: " + ended.err;
}

}  // namespace flipside::faults

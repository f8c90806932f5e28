#include "world/json_file.hpp"

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <new>
#include <numbers>

#include "world/input_error.hpp"

namespace flipside {

namespace {

constexpr std::size_t deepest_nesting = 64;
constexpr std::size_t longest_word = 60;  ///< of a message

/// One line of ASCII: everything else as JSON escapes.
std::string escaped(std::string_view word) {
    const std::string shown(word.substr(0, longest_word));
    const std::string text = Json(shown).dump(-1, ' ', /*ensure_ascii=*/true, Json::error_handler_t::replace);
    return text.substr(1, text.size() - 2) + (word.size() > longest_word ? "..." : "");
}

/// The library's "[json.exception...] parse error at line 1, column 2: what" as ours.
InputError syntax_error(const std::string& file, const std::string& message) {
    const std::size_t line = message.find("line ");
    const std::size_t colon = message.find(": ");
    if (line == std::string::npos || colon == std::string::npos)
        return {file, "", "not JSON: " + escaped(message)};
    std::string problem;
    for (const char c : message.substr(colon + 2)) problem += c >= ' ' && c <= '~' ? c : '?';
    return {file, message.substr(line, colon - line), "not JSON: " + problem};
}

/// Builds the document from what the parser finds, and refuses what the parser would let pass. (The
/// library's own callbacks take quadratic time in long arrays.)
class Builder : public nlohmann::json_sax<Json> {
  public:
    explicit Builder(const std::string& file) : file_(file) {}
    [[nodiscard]] Json take() { return std::move(document_); }

    bool null() override { return add(nullptr), true; }
    bool boolean(bool value) override { return add(value), true; }
    bool number_integer(number_integer_t value) override { return add(value), true; }
    bool number_unsigned(number_unsigned_t value) override { return add(value), true; }
    bool number_float(number_float_t value, const string_t& /*text*/) override { return add(value), true; }
    bool string(string_t& value) override { return add(std::move(value)), true; }
    bool binary(binary_t& /*value*/) override { return false; }  // JSON has none
    bool start_object(std::size_t /*size*/) override { return open(Json::object()), true; }
    bool start_array(std::size_t /*size*/) override { return open(Json::array()), true; }
    bool end_object() override { return levels_.pop_back(), true; }
    bool end_array() override { return levels_.pop_back(), true; }
    bool key(string_t& key) override {
        levels_.back().key = std::move(key);
        if (levels_.back().value->contains(levels_.back().key))
            throw InputError(file_, pointer(), "this key is here twice; allowed is once");
        return true;
    }
    bool parse_error(std::size_t /*position*/, const std::string& /*token*/,
                     const Json::exception& error) override {
        if (dynamic_cast<const Json::out_of_range*>(&error) != nullptr)
            throw InputError(file_, pointer(), "this number is beyond the range of a double");
        throw syntax_error(file_, error.what());
    }

  private:
    struct Level {
        Json* value;
        std::string key;  ///< of an object: the last one read
    };

    Json* add(Json value) {
        if (levels_.empty()) return &(document_ = std::move(value));
        Json& parent = *levels_.back().value;
        if (parent.is_array()) return &parent.emplace_back(std::move(value));
        return &(parent[levels_.back().key] = std::move(value));
    }
    void open(Json container) {
        if (levels_.size() == deepest_nesting)
            throw InputError(file_, pointer(), "nested too deep; allowed are 64 levels");
        levels_.push_back({add(std::move(container)), {}});
    }
    /// Of the value that is read next.
    [[nodiscard]] std::string pointer() const {
        std::string text;
        for (const Level& level : levels_) {
            // An array already holds the level that is open in it.
            const std::size_t entries = level.value->size();
            const bool innermost = &level == &levels_.back();
            text += '/';
            text += level.value->is_object() ? pointer_token(level.key)
                                             : std::to_string(innermost ? entries : entries - 1);
        }
        return text;
    }

    const std::string& file_;
    Json document_;
    std::vector<Level> levels_;
};

}  // namespace

std::string read_file(const std::filesystem::path& file, std::uintmax_t largest) {
    const std::string name = file.string();
    std::error_code error;
    const auto status = std::filesystem::status(file, error);
    if (status.type() == std::filesystem::file_type::none)
        throw InputError(name, "", "cannot be read: " + error.message());
    if (!std::filesystem::exists(status)) throw InputError(name, "", "there is no such file");
    if (!std::filesystem::is_regular_file(status)) throw InputError(name, "", "this is not a regular file");
    const std::uintmax_t size = std::filesystem::file_size(file, error);
    if (error) throw InputError(name, "", "cannot be read: " + error.message());
    if (size > largest)
        throw InputError(name, "",
                         "this file is too large; allowed are " + std::to_string(largest >> 20U) + " MB");
    std::ifstream stream(file, std::ios::binary);
    if (!stream && errno == ENOMEM) throw std::bad_alloc();  // that is no fault of the file
    if (!stream) throw InputError(name, "", "cannot be read: " + std::generic_category().message(errno));
    std::string text(size, '\0');
    if (!stream.read(text.data(), static_cast<std::streamsize>(size)))
        throw InputError(name, "", "cannot be read");
    return text;
}

Json parse_json(std::string_view text, const std::string& file) {
    if (text.find_first_not_of(" \t\r\n") == std::string_view::npos)
        throw InputError(file, "", "not JSON: the file is empty");
    // The parser takes this character for the end of the text.
    if (const std::size_t at = text.find('\0'); at != std::string_view::npos) {
        const std::string_view before = text.substr(0, at);
        const auto lines = std::ranges::count(before, '\n');
        const std::size_t column = at - before.rfind('\n');  // in the first line npos is -1
        throw InputError(file, "line " + std::to_string(lines + 1) + ", column " + std::to_string(column),
                         "not JSON: a NUL character");
    }
    Builder builder(file);
    Json::sax_parse(text, &builder);
    return builder.take();
}

std::string in_quotes(std::string_view word) {
    return '"' + escaped(word) + '"';
}

std::string pointer_token(std::string_view key) {
    std::string token;
    for (const char c : escaped(key)) {
        if (c == '~')
            token += "~0";
        else if (c == '/')
            token += "~1";
        else
            token += c;
    }
    return token;
}

Node Node::at(const std::string& key) const {
    return {value_->at(key), *file_, pointer_ + "/" + pointer_token(key)};
}

Node Node::at(std::size_t index) const {
    return {value_->at(index), *file_, pointer_ + "/" + std::to_string(index)};
}

std::vector<Node> Node::each(const char* key) const {
    std::vector<Node> nodes;
    if (!has(key)) return nodes;
    const Node array = at(key);
    nodes.reserve(array.size());
    for (std::size_t i = 0; i < array.size(); ++i) nodes.push_back(array.at(i));
    return nodes;
}

double Node::radians(const char* key_deg) const {
    return real(key_deg) * std::numbers::pi / 180;
}

std::int64_t Node::integer(const char* key, std::int64_t fallback) const {
    // A whole number may be written as 3.0.
    return static_cast<std::int64_t>(value_->value(key, static_cast<double>(fallback)));
}

bool Node::toggle(const char* key, bool fallback) const {
    return value_->value(key, fallback);
}

std::string Node::text(const char* key, const char* fallback) const {
    return value_->value(key, std::string(fallback));
}

Vec2 Node::vector() const {
    return {(*value_)[0].get<double>(), (*value_)[1].get<double>()};
}

Vec2 Node::vector(const char* key, Vec2 fallback) const {
    const auto found = value_->find(key);
    if (found == value_->end()) return fallback;
    return {(*found)[0].get<double>(), (*found)[1].get<double>()};
}

void Node::fail(const std::string& problem) const {
    throw InputError(*file_, pointer_, problem);
}

}  // namespace flipside

#pragma once
/// JSON files as unchecked input: reads them, and names positions in them.

#include <filesystem>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "world/vec2.hpp"

namespace flipside {

using Json = nlohmann::json;

/// The whole file. Throws InputError when it cannot be read, is no regular file or is larger than `largest`
/// bytes.
[[nodiscard]] std::string read_file(const std::filesystem::path& file, std::uintmax_t largest = 64U << 20U);

/// Throws InputError with line and column where the text is not JSON, and with the JSON pointer where
/// a key is there twice, a number is beyond double's range, or the nesting is deeper than 64.
[[nodiscard]] Json parse_json(std::string_view text, const std::string& file);

/// JSON to be written, in ASCII alone: so that no text in it means anything to a terminal. Bytes that are no
/// UTF-8 become U+FFFD. `indent` as in nlohmann::json::dump: -1 is one line.
template <class AnyJson>
[[nodiscard]] std::string json_text(const AnyJson& json, int indent = -1) {
    return json.dump(indent, ' ', /*ensure_ascii=*/true, AnyJson::error_handler_t::replace);
}

/// A word from a file as error messages show it: quoted, on one line, in ASCII, not too long.
[[nodiscard]] std::string in_quotes(std::string_view word);
/// The names of things for error messages, the first of them where there are many. `name` gives "" for
/// what shall not be listed.
template <class Things, class Name>
[[nodiscard]] std::string names_of(const Things& things, Name name) {
    constexpr int enough = 20;
    int count = 0;
    std::string text;
    for (const auto& thing : things) {
        const std::string word = name(thing);
        if (word.empty()) continue;
        if (++count > enough) return text + ", ...";
        text += (text.empty() ? "" : ", ") + in_quotes(word);
    }
    return text.empty() ? "none, for there are none" : text;
}
/// A key as a part of a JSON pointer (RFC 6901), on one line.
[[nodiscard]] std::string pointer_token(std::string_view key);

/// A value of a document and where it is. Getters rely on check_form having passed the document; the
/// document and the file name must outlive the node.
class Node {
  public:
    Node(const Json& value, const std::string& file, std::string pointer = {})
        : value_(&value), file_(&file), pointer_(std::move(pointer)) {}

    [[nodiscard]] const Json& json() const { return *value_; }
    [[nodiscard]] const std::string& file() const { return *file_; }
    [[nodiscard]] const std::string& pointer() const { return pointer_; }
    [[nodiscard]] bool has(const char* key) const { return value_->contains(key); }
    [[nodiscard]] std::size_t size() const { return value_->size(); }
    [[nodiscard]] Node at(const std::string& key) const;
    [[nodiscard]] Node at(std::size_t index) const;
    /// The entries of an array that may be missing.
    [[nodiscard]] std::vector<Node> each(const char* key) const;

    [[nodiscard]] double real(const char* key) const { return value_->at(key).get<double>(); }
    [[nodiscard]] double real(const char* key, double fallback) const { return value_->value(key, fallback); }
    [[nodiscard]] double radians(const char* key_deg) const;
    [[nodiscard]] std::int64_t integer(const char* key, std::int64_t fallback = 0) const;
    [[nodiscard]] bool toggle(const char* key, bool fallback = false) const;
    [[nodiscard]] std::string text(const char* key, const char* fallback = "") const;
    [[nodiscard]] Vec2 vector(const char* key, Vec2 fallback = {}) const;
    [[nodiscard]] Vec2 vector() const;

    [[noreturn]] void fail(const std::string& problem) const;
    [[noreturn]] void fail(const char* key, const std::string& problem) const { at(key).fail(problem); }

  private:
    const Json* value_;
    const std::string* file_;
    std::string pointer_;
};

}  // namespace flipside

#pragma once
/// Changes a JSON text in place: finds where a value stands, and says which letters have to become others so
/// that the text means something else. All that is not concerned keeps its letters: order, spaces, numbers.
/// (The idea of jsonc-parser's modify(), Microsoft, 2018.)

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

namespace flipside::lab {

/// Keeps the order of keys.
using OrderedJson = nlohmann::ordered_json;
/// Keys and indices from the outermost value inwards.
using Path = std::vector<std::string>;

/// Letters of a text, from `begin` to before `end`.
struct Span {
    std::size_t begin = 0, end = 0;
};

/// These letters of a text become others.
struct Splice {
    std::size_t at = 0;
    std::string removed, inserted;

    friend bool operator==(const Splice&, const Splice&) = default;
};

/// The value at a path, or null.
[[nodiscard]] const OrderedJson* find(const OrderedJson& json, const Path& path);
/// Where that value stands in the text, which must be JSON. Cost: O(n).
[[nodiscard]] std::optional<Span> find(std::string_view text, const Path& path);

/// Makes the value at the path, which is there, into another one. Of objects, and of arrays of one length,
/// only what differs is replaced. The splices are for the text as it is, in rising order and apart.
[[nodiscard]] std::vector<Splice> replacing(std::string_view text, const Path& path,
                                            const OrderedJson& value);
/// Adds a key to an object, as the last one, or an element to an array. It stands as the one before it does.
[[nodiscard]] Splice adding(std::string_view text, const Path& container, const std::string& key,
                            const OrderedJson& value);
/// Takes an entry away, with its comma.
[[nodiscard]] Splice removing(std::string_view text, const Path& path);

/// On one line, with a space after commas and colons; in ASCII.
[[nodiscard]] std::string spaced(const OrderedJson& json);
/// An object as a file for people: its entries in lines, and in those that hold several things, each of
/// these.
[[nodiscard]] std::string laid_out(const OrderedJson& json);
/// A whole number is written as one.
[[nodiscard]] OrderedJson number(double value);

}  // namespace flipside::lab

#include "lab/editor/json_text.hpp"

#include <charconv>
#include <cmath>

#include "world/json_file.hpp"

namespace flipside::lab {

namespace {

/// Of an object (with the key as it is written, quotes included) or an array.
struct Entry {
    Span key, value;
};

bool is_space(char c) {
    return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

std::size_t after_space(std::string_view text, std::size_t at) {
    while (at < text.size() && is_space(text[at])) ++at;
    return at;
}

std::size_t after_string(std::string_view text, std::size_t at) {
    for (++at; text[at] != '"'; ++at)
        if (text[at] == '\\') ++at;
    return at + 1;
}

std::size_t after_value(std::string_view text, std::size_t at) {
    int depth = 0;
    do {
        const char c = text[at];
        if (c == '"') {
            at = after_string(text, at);
            continue;
        }
        if (c == '{' || c == '[') {
            ++depth;
        } else if (c == '}' || c == ']') {
            --depth;
        } else if (depth == 0) {  // a number or word
            while (at < text.size() && !is_space(text[at]) && std::string_view(",]}").find(text[at]) > 2)
                ++at;
            return at;
        }
        ++at;
    } while (depth > 0);
    return at;
}

std::vector<Entry> entries_of(std::string_view text, Span container) {
    std::vector<Entry> entries;
    const bool object = text[container.begin] == '{';
    std::size_t at = after_space(text, container.begin + 1);
    while (at + 1 < container.end) {
        Entry entry{{at, at}, {}};
        if (object) {
            entry.key.end = after_string(text, at);
            at = after_space(text, after_space(text, entry.key.end) + 1);  // the colon
        }
        entry.value = {at, after_value(text, at)};
        entries.push_back(entry);
        at = after_space(text, entry.value.end);
        if (text[at] == ',') at = after_space(text, at + 1);
    }
    return entries;
}

std::string key_of(std::string_view text, const Entry& entry) {
    return OrderedJson::parse(text.substr(entry.key.begin, entry.key.end - entry.key.begin))
        .get<std::string>();
}

std::optional<std::size_t> index_of(const std::string& token) {
    std::size_t index = 0;
    const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), index);
    return error == std::errc() && end == token.data() + token.size() ? std::optional(index) : std::nullopt;
}

/// Of the entry that a token names.
std::optional<std::size_t> position_of(std::string_view text, Span container,
                                       const std::vector<Entry>& entries, const std::string& token) {
    if (text[container.begin] != '{') {
        const auto index = index_of(token);
        return index && *index < entries.size() ? index : std::nullopt;
    }
    for (std::size_t i = 0; i < entries.size(); ++i)
        if (key_of(text, entries[i]) == token) return i;
    return std::nullopt;
}

std::string_view letters(std::string_view text, Span span) {
    return text.substr(span.begin, span.end - span.begin);
}

Splice exchange(std::string_view text, Span span, std::string inserted) {
    return {span.begin, std::string(letters(text, span)), std::move(inserted)};
}

bool same_keys(const OrderedJson& a, const OrderedJson& b) {
    if (a.size() != b.size()) return false;
    for (const auto& entry : a.items())
        if (!b.contains(entry.key())) return false;
    return true;
}

void append_differences(std::string_view text, Span span, const OrderedJson& value,
                        std::vector<Splice>& splices) {
    const char first = text[span.begin];
    if (first != '{' && first != '[') {
        if (OrderedJson::parse(letters(text, span)) != value)
            splices.push_back(exchange(text, span, spaced(value)));
        return;
    }
    const OrderedJson before = OrderedJson::parse(letters(text, span));
    if (before == value) return;
    const bool alike = first == '{' ? value.is_object() && same_keys(before, value)
                                    : value.is_array() && before.size() == value.size();
    if (!alike) {
        splices.push_back(exchange(text, span, spaced(value)));
        return;
    }
    std::size_t i = 0;
    for (const Entry& entry : entries_of(text, span)) {
        append_differences(text, entry.value, first == '{' ? value.at(key_of(text, entry)) : value.at(i),
                           splices);
        ++i;
    }
}

/// The spaces with which the line begins that `at` is in.
std::string indent_of(std::string_view text, std::size_t at) {
    std::size_t begin = at;
    while (begin > 0 && text[begin - 1] != '\n') --begin;
    return std::string(text.substr(begin, after_space(text, begin) - begin));
}

}  // namespace

const OrderedJson* find(const OrderedJson& json, const Path& path) {
    const OrderedJson* value = &json;
    for (const std::string& token : path) {
        if (value->is_object()) {
            const auto at = value->find(token);
            if (at == value->end()) return nullptr;
            value = &*at;
        } else {
            const auto index = index_of(token);
            if (!value->is_array() || !index || *index >= value->size()) return nullptr;
            value = &value->at(*index);
        }
    }
    return value;
}

std::optional<Span> find(std::string_view text, const Path& path) {
    const std::size_t begin = after_space(text, 0);
    Span span{begin, after_value(text, begin)};
    for (const std::string& token : path) {
        if (text[span.begin] != '{' && text[span.begin] != '[') return std::nullopt;
        const std::vector<Entry> entries = entries_of(text, span);
        const auto position = position_of(text, span, entries, token);
        if (!position) return std::nullopt;
        span = entries[*position].value;
    }
    return span;
}

std::vector<Splice> replacing(std::string_view text, const Path& path, const OrderedJson& value) {
    std::vector<Splice> splices;
    append_differences(text, find(text, path).value(), value, splices);
    return splices;
}

Splice adding(std::string_view text, const Path& container, const std::string& key,
              const OrderedJson& value) {
    const Span span = find(text, container).value();
    const bool object = text[span.begin] == '{';
    const std::string written = (object ? json_text(OrderedJson(key)) + ": " : std::string()) + spaced(value);
    const std::vector<Entry> entries = entries_of(text, span);
    if (entries.empty()) {
        const std::string indent = indent_of(text, span.begin);
        const std::string inside =
            object && !container.empty() ? written : "\n" + indent + "  " + written + "\n" + indent;
        return exchange(text, {span.begin + 1, span.end - 1}, inside);
    }
    const Entry& last = entries.back();
    std::size_t space = last.key.begin;
    while (is_space(text[space - 1])) --space;
    std::string between(text.substr(space, last.key.begin - space));
    if (between.empty() && entries.size() == 1) between = " ";
    return {last.value.end, "", "," + between + written};
}

Splice removing(std::string_view text, const Path& path) {
    const Path container(path.begin(), path.end() - 1);
    const Span span = find(text, container).value();
    const std::vector<Entry> entries = entries_of(text, span);
    const std::size_t i = position_of(text, span, entries, path.back()).value();
    if (i > 0) return exchange(text, {entries[i - 1].value.end, entries[i].value.end}, "");
    if (entries.size() > 1) return exchange(text, {entries[0].key.begin, entries[1].key.begin}, "");
    return exchange(text, {span.begin + 1, span.end - 1}, "");
}

std::string spaced(const OrderedJson& json) {
    if (!json.is_structured()) return json_text(json);
    std::string text;
    for (const auto& entry : json.items()) {
        if (!text.empty()) text += ", ";
        if (json.is_object()) text += json_text(OrderedJson(entry.key())) + ": ";
        text += spaced(entry.value());
    }
    return json.is_object() ? "{" + text + "}" : "[" + text + "]";
}

std::string laid_out(const OrderedJson& json) {
    const auto in_lines = [](const OrderedJson& container, const std::string& indent, const auto& write) {
        std::string text;
        for (const auto& entry : container.items()) {
            text += (text.empty() ? "" : ",") + ("\n" + indent + "  ");
            if (container.is_object()) text += json_text(OrderedJson(entry.key())) + ": ";
            text += write(entry.value());
        }
        return container.is_object() ? "{" + text + "\n" + indent + "}" : "[" + text + "\n" + indent + "]";
    };
    const auto holds_things = [](const OrderedJson& value) {
        return value.is_structured() && !value.empty() && value.front().is_structured() &&
               !value.front().is_array();
    };
    return in_lines(json, "",
                    [&](const OrderedJson& value) {
                        return holds_things(value) ? in_lines(value, "  ", spaced) : spaced(value);
                    }) +
           "\n";
}

OrderedJson number(double value) {
    constexpr double exact = 1e15;  // all whole numbers below are doubles
    if (value == std::floor(value) && std::abs(value) < exact) return static_cast<std::int64_t>(value);
    return value;
}

}  // namespace flipside::lab

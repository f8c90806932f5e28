#include "world/schema.hpp"

#include <map>
#include <memory>
#include <mutex>

#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

#include "world/input_error.hpp"

// valijson says whether a value is as a schema asks. Where it is not, valijson is asked about ever smaller
// parts until the smallest wrong one is found, and what its schema allows is put into words. (valijson's
// own reports do not say what is allowed, and fill the memory where a large file is wrong everywhere.)

namespace flipside {

namespace {

/// The part of a schema that speaks of `value`: references are followed, and of the alternatives that
/// tell by a key of the value ("type"), the one that applies is taken.
const Json& resolve(const Json& root, const Json& schema, const Json& value) {
    if (const auto ref = schema.find("$ref"); ref != schema.end())
        return resolve(root, root.at(Json::json_pointer(ref->get<std::string>().substr(1))), value);
    if (!schema.contains("allOf")) return schema;
    for (const Json& alternative : schema["allOf"]) {
        const auto test = alternative.at("if").at("properties").items().begin();
        if (value.is_object() && value.contains(test.key()) && value[test.key()] == test.value().at("const"))
            return resolve(root, alternative.at("then"), value);
    }
    return schema;
}

std::string list(const Json& words) {
    std::string text;
    for (const Json& word : words) text += (text.empty() ? "" : ", ") + word.get<std::string>();
    return text;
}

std::string keys(const Json& object) {
    std::string text;
    for (const auto& entry : object.items()) text += (text.empty() ? "" : ", ") + entry.key();
    return text;
}

/// " from MIN to MAX" or " above MIN, up to MAX", as far as there are limits.
std::string limits(const Json& schema, const char* least, const char* most) {
    std::string text;
    const bool above = schema.contains("exclusiveMinimum");
    if (schema.contains(least)) text += " from " + schema[least].dump();
    if (above) text += " above " + schema["exclusiveMinimum"].dump();
    if (schema.contains(most)) text += (above ? ", up to " : " to ") + schema[most].dump();
    return text;
}

/// What a place takes, in words.
std::string allowed(const Json& root, const Json& schema) {
    if (schema.contains("const")) return schema["const"].dump();
    if (schema.contains("enum")) return list(schema["enum"]);
    if (!schema.contains("type")) return "anything";
    const Json& type = schema["type"];
    if (type.is_array()) return "a " + list(type);
    if (type == "number") return "a number" + limits(schema, "minimum", "maximum");
    if (type == "integer") return "a whole number" + limits(schema, "minimum", "maximum");
    if (type == "boolean") return "true or false";
    if (type == "string")
        return "a text" + (schema.contains("maxLength")
                               ? " of" + limits(schema, "minLength", "maxLength") + " characters"
                               : "");
    if (type == "array") {
        const std::string items = allowed(root, resolve(root, schema["items"], nullptr));
        if (schema.contains("minItems") && schema["minItems"] == schema["maxItems"])
            return "an array of exactly " + schema["minItems"].dump() + ", each " + items;
        return "an array" + limits(schema, "minItems", "maxItems") + " long, each " + items;
    }
    if (schema.contains("properties")) return "an object with the keys " + keys(schema["properties"]);
    return "an object";
}

std::string shown(const Json& value) {
    if (value.is_string()) return in_quotes(value.get_ref<const std::string&>());
    if (value.is_object()) return "an object";
    if (value.is_array()) return "an array of " + std::to_string(value.size());
    return value.dump();
}

/// The schema of a member of an object or array; null where there is none.
const Json* member_schema(const Json& schema, const Json& value, const std::string& key) {
    const auto find = [&](const char* what) {
        const auto found = schema.find(what);
        return found != schema.end() && found->is_object() ? &*found : nullptr;
    };
    if (value.is_array()) return find("items");
    if (!value.is_object()) return nullptr;
    const Json* properties = find("properties");
    return properties != nullptr && properties->contains(key) ? &(*properties)[key]
                                                              : find("additionalProperties");
}

[[noreturn]] void refuse(const Json& root, const Json& schema, const Json& value, const std::string& file,
                         const std::string& pointer) {
    if (value.is_object() && schema.value("type", Json()) == "object") {
        const Json known = schema.value("properties", Json::object());
        if (schema.contains("additionalProperties") && schema["additionalProperties"] == false)
            for (const auto& entry : value.items())
                if (!known.contains(entry.key()))
                    throw InputError(file, pointer + "/" + pointer_token(entry.key()),
                                     "unknown key; allowed: " + keys(known));
        for (const Json& key : schema.value("required", Json::array()))
            if (!value.contains(key.get<std::string>()))
                throw InputError(file, pointer,
                                 "the key " + key.dump() + " is missing; it takes " +
                                     allowed(root, resolve(root, known[key.get<std::string>()], nullptr)));
    }
    throw InputError(file, pointer, "is " + shown(value) + "; allowed: " + allowed(root, schema));
}

/// A schema, with what valijson makes of it and its parts.
class Form {
  public:
    explicit Form(std::string_view text) : root_(Json::parse(text)) {}

    /// Asks valijson, and finds the smallest wrong part.
    void check(const Node& node) {
        if (passes(root_, node.json())) return;
        require_format(node);
        refuse_smallest(root_, node.json(), node.file(), node.pointer());
    }

  private:
    /// A file of another kind is refused as such, whatever else in it is unlike what is expected.
    void require_format(const Node& node) {
        const Json& document = node.json();
        const Json* format = member_schema(root_, document, "format");
        if (format == nullptr || !document.contains("format") || passes(*format, document["format"])) return;
        refuse(root_, *format, document["format"], node.file(), node.pointer() + "/format");
    }

    /// `schema` must be resolved or the root.
    bool passes(const Json& schema, const Json& value) {
        auto& parsed = parsed_[&schema];
        if (!parsed) {
            Json whole = schema;
            // What references point to. A schema without any may have none.
            if (root_.contains("definitions")) whole["definitions"] = root_["definitions"];
            parsed = std::make_unique<valijson::Schema>();
            valijson::SchemaParser(valijson::SchemaParser::kDraft7)
                .populateSchema(valijson::adapters::NlohmannJsonAdapter(whole), *parsed);
        }
        return validator_.validate(*parsed, valijson::adapters::NlohmannJsonAdapter(value), nullptr);
    }

    /// `value` does not pass.
    [[noreturn]] void refuse_smallest(const Json& schema, const Json& value, const std::string& file,
                                      const std::string& pointer) {
        for (const auto& member : value.items()) {
            const Json* of_member = member_schema(schema, value, member.key());
            if (of_member == nullptr) continue;
            const Json& resolved = resolve(root_, *of_member, member.value());
            if (!passes(resolved, member.value()))
                refuse_smallest(resolved, member.value(), file, pointer + "/" + pointer_token(member.key()));
        }
        refuse(root_, schema, value, file, pointer);
    }

    Json root_;
    valijson::Validator validator_;
    std::map<const Json*, std::unique_ptr<valijson::Schema>> parsed_;  ///< never iterated
};

}  // namespace

void check_form(const Json& document, std::string_view schema, const std::string& file) {
    check_form(Node(document, file), schema);
}

void check_form(const Node& node, std::string_view schema) {
    // To parse a schema takes longer than to check most files, so each is kept. A sweep checks thousands of
    // states.
    static std::mutex mutex;
    static std::map<std::string_view, Form> forms;
    const std::lock_guard lock(mutex);
    forms.try_emplace(schema, schema).first->second.check(node);
}

}  // namespace flipside

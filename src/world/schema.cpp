#include "world/schema.hpp"

#include <optional>

#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validation_results.hpp>
#include <valijson/validator.hpp>

#include "world/input_error.hpp"

// valijson finds the first place that is wrong. It does not say what would be right there, so the message
// is made here: the schema of that place is sought on the way from the root, and put into words.

namespace flipside {

namespace {

/// The keys from the root to a value, as valijson writes them: "<root>", "[parts]", "[0]".
using Context = std::vector<std::string>;

std::optional<Context> first_error(const Json& document, const Json& schema) {
    valijson::Schema parsed;
    valijson::SchemaParser(valijson::SchemaParser::kDraft7)
        .populateSchema(valijson::adapters::NlohmannJsonAdapter(schema), parsed);
    const valijson::adapters::NlohmannJsonAdapter target(document);
    valijson::Validator validator;
    if (validator.validate(parsed, target, nullptr)) return std::nullopt;
    valijson::ValidationResults results;
    validator.validate(parsed, target, &results);
    return results.begin()->context;
}

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

/// " from MIN to MAX" as far as there are limits.
std::string limits(const Json& schema, const char* least, const char* most) {
    std::string text;
    if (schema.contains(least)) text += " from " + schema[least].dump();
    if (schema.contains(most)) text += " to " + schema[most].dump();
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

/// The schema of a member of an object or array.
const Json& member_schema(const Json& schema, const std::string& key) {
    if (schema.contains("items")) return schema["items"];
    if (schema.contains("properties") && schema["properties"].contains(key)) return schema["properties"][key];
    return schema.at("additionalProperties");
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

}  // namespace

void check_form(const Json& document, std::string_view schema_text, const std::string& file) {
    const Json root = Json::parse(schema_text);
    const std::optional<Context> context = first_error(document, root);
    if (!context) return;
    const Json* value = &document;
    const Json* schema = &resolve(root, root, document);
    std::string pointer;
    for (std::size_t i = 1; i < context->size(); ++i) {
        const std::string key = (*context)[i].substr(1, (*context)[i].size() - 2);
        value = value->is_array() ? &(*value)[std::stoul(key)] : &(*value)[key];
        schema = &resolve(root, member_schema(*schema, key), *value);
        pointer += "/" + pointer_token(key);
    }
    refuse(root, *schema, *value, file, pointer);
}

}  // namespace flipside

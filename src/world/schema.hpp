#pragma once
/// The form of the files: which keys there are, of which type and range. What a form cannot say (that a
/// polygon is convex, that a material exists) is checked by the reader of each file.

#include <string_view>

#include "world/json_file.hpp"

namespace flipside {

/// The texts of assets/*.schema.json.
extern const std::string_view scene_schema;
extern const std::string_view script_schema;
extern const std::string_view state_schema;
extern const std::string_view trace_schema;
extern const std::string_view lesson_schema;
extern const std::string_view window_schema;
extern const std::string_view scores_schema;
extern const std::string_view certificate_schema;
extern const std::string_view hard_schema;
extern const std::string_view replay_schema;

/// Throws InputError for the first place where the document is not as the schema (JSON Schema draft 7)
/// asks. The message says what is allowed there.
void check_form(const Json& document, std::string_view schema, const std::string& file);
/// The same of a part of a document.
void check_form(const Node& node, std::string_view schema);

}  // namespace flipside

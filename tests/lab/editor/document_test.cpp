#include "lab/editor/document.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "lab/files/assets.hpp"
#include "world/json_file.hpp"

namespace flipside::lab {
namespace {

constexpr const char* letters = R"({
  "format" : "x",   "rate":1.50,
  "parts": [
    {"name": "a", "at": [0.10, 2e-1]},
    {"name": "b\"]", "at": [3, 4]}
  ],
  "none": {}, "rules": {"score": {"a": 1}}
})";

TEST(Document, ChangesNoLetterThatItNeedNot) {
    Document document(letters);
    document.set({"parts", "0", "at"}, {0.1, 0.25});
    std::string wanted = letters;
    wanted.replace(wanted.find("2e-1"), 4, "0.25");
    EXPECT_EQ(document.text(), wanted);
}

TEST(Document, WhatIsTheSameIsNotWrittenAnew) {
    Document document(letters);
    document.set({"parts", "0"}, OrderedJson::parse(R"({"name": "a", "at": [0.1, 0.2]})"));
    EXPECT_EQ(document.text(), letters);
    EXPECT_FALSE(document.can_undo());
}

TEST(Document, AnElementStandsAsTheOneBefore) {
    Document document(letters);
    document.append({"parts"}, OrderedJson::parse(R"({"name":"c","at":[1,1.5]})"));
    std::string wanted = letters;
    const std::string last = R"([3, 4]})";
    wanted.insert(wanted.find(last) + last.size(), ",\n    {\"name\": \"c\", \"at\": [1, 1.5]}");
    EXPECT_EQ(document.text(), wanted);
}

TEST(Document, TakesAnEntryAwayWithItsComma) {
    Document document(letters);
    document.remove({"parts", "0"});
    document.remove({"rules", "score", "a"});
    document.remove({"rate"});
    EXPECT_EQ(document.text(), R"({
  "format" : "x",
  "parts": [
    {"name": "b\"]", "at": [3, 4]}
  ],
  "none": {}, "rules": {"score": {}}
})");
}

TEST(Document, AddsWhatIsMissing) {
    Document document("{\n  \"format\": \"x\"\n}\n");
    document.append({"parts"}, 1);
    document.append({"parts"}, 2);
    document.set({"name"}, "n");
    EXPECT_EQ(document.text(),
              "{\n  \"format\": \"x\",\n  \"parts\": [\n    1,\n    2\n  ],\n  \"name\": \"n\"\n}\n");
}

TEST(Document, AStepIsUndoneAndDoneAgainAsAWhole) {
    Document document(letters);
    document.set({"rate"}, 2);
    document.set({"format"}, "y");
    document.end_step();
    document.remove({"parts"});
    const std::string last = document.text();
    EXPECT_TRUE(document.undo());
    EXPECT_EQ(document.json().at("rate"), 2);
    EXPECT_TRUE(document.undo());
    EXPECT_EQ(document.text(), letters);
    EXPECT_FALSE(document.undo());
    EXPECT_TRUE(document.redo());
    EXPECT_TRUE(document.redo());
    EXPECT_FALSE(document.redo());
    EXPECT_EQ(document.text(), last);
}

TEST(Document, WhatIsRevertedLeavesNoStep) {
    Document document(letters);
    document.set({"rate"}, 2);
    document.revert_step();
    EXPECT_EQ(document.text(), letters);
    EXPECT_FALSE(document.can_undo());
}

TEST(Document, EditsThatCancelAreNoStep) {
    Document document(letters);
    document.set({"rate"}, 2);
    document.end_step();
    document.append({"parts"}, 1);
    document.remove({"parts", "2"});
    EXPECT_TRUE(document.undo());
    EXPECT_EQ(document.text(), letters);
    EXPECT_FALSE(document.undo());
    EXPECT_TRUE(document.redo());
    EXPECT_EQ(document.json().at("rate"), 2);
}

TEST(Document, ForgetsTheOldestSteps) {
    Document document("{\"x\": -1}");
    for (std::size_t i = 0; i < Document::most_steps + 10; ++i) {
        document.set({"x"}, i);
        document.end_step();
    }
    std::size_t steps = 0;
    while (document.undo()) ++steps;
    EXPECT_EQ(steps, Document::most_steps);
    EXPECT_EQ(document.json().at("x"), 9);
}

TEST(Document, IsLaidOutAsPeopleWriteIt) {
    const OrderedJson json = OrderedJson::parse(
        R"({"bounds":{"max":[1,1]},"materials":{"m":{"kick":1}},"parts":[{"name":"a"},{"name":"b"}],"balls":[]})");
    EXPECT_EQ(laid_out(json), R"({
  "bounds": {"max": [1, 1]},
  "materials": {
    "m": {"kick": 1}
  },
  "parts": [
    {"name": "a"},
    {"name": "b"}
  ],
  "balls": []
}
)");
    EXPECT_EQ(OrderedJson::parse(laid_out(json)), json);
}

/// Every path into a document.
void append_paths(const OrderedJson& json, const Path& path, std::vector<Path>& paths) {
    if (!path.empty()) paths.push_back(path);
    std::size_t i = 0;
    for (const auto& entry : json.items()) {
        Path inner = path;
        inner.push_back(json.is_object() ? entry.key() : std::to_string(i));
        if (json.is_structured()) append_paths(entry.value(), inner, paths);
        ++i;
    }
}

OrderedJson some_value(int kind) {
    switch (kind) {
        case 0:
            return *rc::gen::inRange(-1000, 1000);
        case 1:
            return *rc::gen::inRange(-1000, 1000) * 0.001;
        case 2:
            return *rc::gen::container<std::string>(rc::gen::inRange('\x01', '\x7f'));
        case 3:
            return OrderedJson::array({*rc::gen::inRange(0, 9), *rc::gen::inRange(0, 9)});
        default:
            return {{"type", "x"},
                    {*rc::gen::elementOf(std::vector<std::string>{"a", "b", "/", "~"}), nullptr}};
    }
}

/// Does something to the text and the same to the value, by the library's own means.
void edit_somehow(Document& document, OrderedJson& value) {
    std::vector<Path> paths;
    append_paths(value, {}, paths);
    if (paths.empty()) return document.set({"new"}, value["new"] = 1);
    const Path path = *rc::gen::elementOf(paths);
    OrderedJson* there = &value;
    OrderedJson* above = nullptr;
    for (const std::string& token : path) {
        above = there;
        there = there->is_array() ? &(*there)[std::stoul(token)] : &(*there)[token];
    }
    const OrderedJson fresh = some_value(*rc::gen::inRange(0, 5));
    if (there->is_array() && *rc::gen::arbitrary<bool>()) {
        there->push_back(fresh);
        document.append(path, fresh);
    } else if (*rc::gen::inRange(0, 3) == 0) {
        if (above->is_array())
            above->erase(std::stoul(path.back()));
        else
            above->erase(path.back());
        document.remove(path);
    } else {
        *there = fresh;
        document.set(path, fresh);
    }
}

/// The same whatever the order of keys.
nlohmann::json unordered(const OrderedJson& json) {
    return nlohmann::json::parse(json.dump());
}

RC_GTEST_PROP(DocumentProperty, SaysWhatTheSameEditsOfAValueSayAndUndoingGivesTheSameBytes, ()) {
    const std::vector<std::string> names = scene_names();
    const std::string before = *rc::gen::inRange(0, 3) == 0
                                   ? std::string(letters)
                                   : read_file(scene_file(*rc::gen::elementOf(names)));
    Document document(before);
    OrderedJson value = OrderedJson::parse(before);
    std::vector<std::string> texts{before};
    const int edits = *rc::gen::inRange(1, 12);
    for (int i = 0; i < edits; ++i) {
        edit_somehow(document, value);
        RC_ASSERT(unordered(OrderedJson::parse(document.text())) == unordered(value));
        RC_ASSERT(unordered(document.json()) == unordered(value));
        if (*rc::gen::arbitrary<bool>() && document.text() != texts.back()) {
            document.end_step();
            texts.push_back(document.text());
        }
    }
    document.end_step();
    if (document.text() != texts.back()) texts.push_back(document.text());
    for (std::size_t i = texts.size() - 1; i > 0; --i) {
        RC_ASSERT(document.text() == texts[i]);
        RC_ASSERT(document.undo());
    }
    while (document.undo()) continue;
    RC_ASSERT(document.text() == before);
    while (document.redo()) continue;
    RC_ASSERT(document.text() == texts.back());
}

}  // namespace
}  // namespace flipside::lab

#include "fuzz/mutator.hpp"

#include <set>

#include <gtest/gtest.h>

#include "world/input_error.hpp"
#include "world/scene_file.hpp"

namespace flipside::fuzz {
namespace {

using Json = nlohmann::json;

constexpr const char* scene =
    R"({"format": "flipside-scene/1", "name": "n", "bounds": {"min": [-1, -1], "max": [1, 1]},
    "balls": [{"position": [0, 0.5], "radius": 0.1, "mass": 1}, {"position": [0.3, 0], "radius": 0.2, "mass": 1}],
    "parts": [{"name": "wall", "shape": {"type": "segment", "a": [-0.5, 0.25], "b": [0.5, 0.25]}}]})";
constexpr std::uint64_t trials = 4000;

bool is_read(const std::string& text) {
    try {
        static_cast<void>(parse_scene(text, "mutated"));
        return true;
    } catch (const InputError&) {
        return false;
    }
}

// A fuzzer learns of engines only through scenes that are read.
TEST(Mutator, ManyOfItsScenesAreReadAndAlmostAllAreOthers) {
    const std::string before = Json::parse(scene).dump();
    std::uint64_t read = 0, same = 0;
    for (std::uint64_t seed = 0; seed < trials; ++seed) {
        const std::string after = Mutator(seed).mutate(scene);
        if (after == before) ++same;
        if (!after.empty() && is_read(after)) ++read;
    }
    EXPECT_GT(read, trials / 3);
    EXPECT_LT(same, trials / 10);
}

TEST(Mutator, GivesTheSameForTheSameSeed) {
    for (std::uint64_t seed = 0; seed < 100; ++seed)
        EXPECT_EQ(Mutator(seed).mutate(scene), Mutator(seed).mutate(scene));
}

bool is_point(const Json& value) {
    return value.is_array() && value.size() == 2 && value[0].is_number() && value[1].is_number();
}

/// The centres of a document's balls, as far as they are points.
std::vector<Vec2> centers_of(const std::string& text) {
    std::vector<Vec2> centers;
    const Json document = Json::parse(text, nullptr, /*allow_exceptions=*/false);
    if (!document.is_object() || !document.contains("balls")) return centers;
    for (const Json& ball : document["balls"])
        if (ball.is_object() && ball.contains("position") && is_point(ball["position"]))
            centers.push_back({ball["position"][0].get<double>(), ball["position"][1].get<double>()});
    return centers;
}

TEST(Mutator, MakesBallsThatJustTouchOrCoincide) {
    bool touch = false, coincide = false, on_bounds = false;
    for (std::uint64_t seed = 0; seed < trials; ++seed) {
        const std::vector<Vec2> centers = centers_of(Mutator(seed).mutate(scene));
        if (centers.size() != 2) continue;
        const double apart = length(centers[1] - centers[0]);
        touch |= std::abs(apart - 0.3) < 1e-15;
        coincide |= apart == 0;
        on_bounds |= centers[0].x == 1 || centers[0].y == 1;
    }
    EXPECT_TRUE(touch);
    EXPECT_TRUE(coincide);
    EXPECT_TRUE(on_bounds);
}

TEST(Mutator, LeavesWhatIsNoDocumentToTheBytes) {
    int left = 0;
    for (std::uint64_t seed = 0; seed < 100; ++seed)
        if (Mutator(seed).mutate("3").empty()) ++left;
    EXPECT_EQ(left, 100);
}

TEST(Mutator, ChangesFieldsOfTables) {
    const std::string table = "name,dt\na,0.5\nb,0.25\n";
    std::set<std::string> found;
    for (std::uint64_t seed = 0; seed < 1000; ++seed) found.insert(Mutator(seed).mutate(table));
    EXPECT_TRUE(found.contains("name,dt\na,nan\nb,0.25\n"));
    EXPECT_TRUE(found.contains("name,dt\na,0.5\na,0.25\n"));
    EXPECT_GT(found.size(), 50U);
}

TEST(Mutator, CrossesDocuments) {
    std::set<std::string> found;
    for (std::uint64_t seed = 0; seed < 1000; ++seed)
        found.insert(Mutator(seed).cross(R"({"a":1,"list":[1]})", R"({"b":2,"list":[7]})"));
    EXPECT_TRUE(found.contains(R"({"a":1,"b":2,"list":[1]})"));
    EXPECT_TRUE(found.contains(R"({"a":1,"list":[1,7]})"));
    for (const char* none : {"{}", "[]"}) {
        EXPECT_EQ(Mutator(1).cross(none, R"({"b":2})"), "");
        EXPECT_EQ(Mutator(1).cross(R"({"b":2})", none), "");
    }
}

}  // namespace
}  // namespace flipside::fuzz

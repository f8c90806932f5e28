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
constexpr int trials = 4000;

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
    int read = 0, same = 0;
    for (int seed = 0; seed < trials; ++seed) {
        const std::string after = Mutator(static_cast<std::uint64_t>(seed)).mutate(scene);
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

TEST(Mutator, MakesBallsThatJustTouchOrCoincide) {
    bool touch = false, coincide = false, on_bounds = false;
    for (int seed = 0; seed < trials; ++seed) {
        const Json after =
            Json::parse(Mutator(static_cast<std::uint64_t>(seed)).mutate(scene), nullptr, false);
        if (!after.contains("balls") || after["balls"].size() != 2) continue;
        const Json& a = after["balls"][0]["position"];
        const Json& b = after["balls"][1]["position"];
        if (!a.is_array() || !b.is_array() || a.size() != 2 || b.size() != 2) continue;
        const double dx = b[0].get<double>() - a[0].get<double>(),
                     dy = b[1].get<double>() - a[1].get<double>();
        touch |= std::abs(std::hypot(dx, dy) - 0.3) < 1e-15;
        coincide |= dx == 0 && dy == 0;
        on_bounds |= a[0] == 1 || a[1] == 1;
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
}

}  // namespace
}  // namespace flipside::fuzz

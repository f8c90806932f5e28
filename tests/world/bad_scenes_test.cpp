// Bad scenes, one per file in tests/world/bad. Its index says which place the error must name, and with
// which words.

#include <fstream>

#include <nlohmann/json.hpp>
#include <unistd.h>

#include "places.hpp"
#include "world/json_file.hpp"
#include "world/support.hpp"

namespace flipside {
namespace {

const std::filesystem::path folder = test::source("tests/world/bad");

std::string load_error(const std::filesystem::path& file) {
    return error_of([&] { (void)load_scene(file); });
}

TEST(BadScenes, EachIsRefusedWithItsPlaceAndReason) {
    const Json index = Json::parse(read_file(folder / "index.json"));
    EXPECT_GE(index.size(), 60U);
    for (const Json& entry : index) {
        const auto file = folder / entry["file"].get<std::string>();
        const auto place = entry["pointer"].get<std::string>();
        const std::string error = load_error(file);
        // A place in the text is followed by its column where the index leaves that open.
        const bool in_text = place.starts_with("line") && place.find("column") == std::string::npos;
        const std::string start = file.string() + ": " + place + (place.empty() || in_text ? "" : ": ");
        expect_error(error, start, entry["says"].get<std::string>());
    }
}

TEST(BadScenes, EveryFileIsInTheIndex) {
    const Json index = Json::parse(read_file(folder / "index.json"));
    std::size_t files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        files += entry.path().filename() != "index.json" ? 1 : 0;
    EXPECT_EQ(files, index.size());
}

TEST(BadScenes, FilesThatCannotBeRead) {
    EXPECT_NE(load_error(folder / "nowhere.json").find("nowhere.json: there is no such file"),
              std::string::npos);
    EXPECT_NE(load_error(folder).find("not a regular file"), std::string::npos);
    const auto huge = std::filesystem::temp_directory_path() /
                      ("flipside-huge-scene-" + std::to_string(getpid()) + ".json");
    std::ofstream(huge) << "{}";
    std::filesystem::resize_file(huge, 64U * 1024 * 1024 + 1);  // sparse
    EXPECT_NE(load_error(huge).find("too large; allowed are 64 MB"), std::string::npos);
    std::filesystem::remove(huge);
}

}  // namespace
}  // namespace flipside

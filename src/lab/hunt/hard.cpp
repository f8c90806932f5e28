#include "lab/hunt/hard.hpp"

#include "lab/files/assets.hpp"
#include "world/input_error.hpp"
#include "world/json_file.hpp"
#include "world/schema.hpp"

namespace flipside::lab::hunt {

namespace fs = std::filesystem;

std::vector<HardScene> hard_scenes(const fs::path& folder) {
    const fs::path file = folder / "hard.json";
    const Json document = parse_json(read_file(file, 1'000'000), file.string());
    check_form(document, hard_schema, file.string());
    std::vector<HardScene> all;
    for (const Json& one : document["scenes"]) {
        const std::string texts[] = {one["contender"]};
        HardScene hard{one["scene"],
                       {.contender = parse_contenders(texts).front(),
                        .goal = goal_named(one["goal"].get<std::string>()),
                        .seconds = one["seconds"]},
                       one["value"]};
        all.push_back(std::move(hard));
    }
    return all;
}

fs::path hard_folder() {
    return assets_folder() / "hard";
}

}  // namespace flipside::lab::hunt

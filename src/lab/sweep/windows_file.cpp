#include <nlohmann/json.hpp>

#include "lab/sweep/windows.hpp"
#include "lab/whole_file.hpp"
#include "world/input_error.hpp"
#include "world/json_file.hpp"
#include "world/state_file.hpp"

namespace flipside::lab::sweep {

namespace {

constexpr const char* format = "flipside-windows/1";

Json json_of(const Window& window, const Scene& scene) {
    Json ends = Json::array(), impacts = Json::array();
    for (const Window::End& end : window.ends)
        ends.push_back({{"ball", end.ball},
                        {"position", {end.position.x, end.position.y}},
                        {"radius", end.radius},
                        {"uncertainty", end.uncertainty},
                        {"hit", end.hit}});
    for (const Event& impact : window.impacts)
        impacts.push_back({{"time", impact.time},
                           {"ball", impact.ball},
                           {impact.other.is_ball ? "other_ball" : "part", impact.other.index},
                           {"speed", impact.speed}});
    return {{"start", Json::parse(to_json(window.start, scene))},
            {"seconds", window.seconds},
            {"ends", ends},
            {"impacts", impacts}};
}

Event read_impact(const Json& json) {
    Event event;
    event.time = json.at("time");
    event.ball = json.at("ball");
    event.other = json.contains("part") ? Other::part(json.at("part")) : Other::ball(json.at("other_ball"));
    event.speed = json.at("speed");
    return event;
}

Window read_window(const Json& json, const std::string& file, const Scene& scene) {
    Window window;
    window.start = parse_state(json.at("start").dump(), file, scene);
    window.seconds = json.at("seconds");
    for (const Json& end : json.at("ends"))
        window.ends.push_back({end.at("ball"),
                               {end.at("position").at(0), end.at("position").at(1)},
                               end.at("radius"),
                               end.at("uncertainty"),
                               end.at("hit")});
    for (const Json& impact : json.at("impacts")) window.impacts.push_back(read_impact(impact));
    return window;
}

}  // namespace

void write_block(const std::filesystem::path& file, const Block& block, const Scene& scene) {
    Json windows = Json::array();
    for (const Window& window : block.windows) windows.push_back(json_of(window, scene));
    const Json json{{"format", format},
                    {"scene", scene.name},
                    {"trajectories", block.trajectories},
                    {"skipped", block.skipped},
                    {"windows", windows}};
    write_whole_file(file, json.dump() + "\n");
}

Block read_block(const std::filesystem::path& file, const Scene& scene) {
    const std::string text = read_file(file);
    try {
        const Json json = Json::parse(text);
        if (json.at("format") != format || json.at("scene") != scene.name)
            throw InputError(file.string(), "", std::string("is no ") + format + " of scene " + scene.name);
        Block block;
        block.trajectories = json.at("trajectories");
        block.skipped = json.at("skipped").get<std::map<std::string, std::size_t>>();
        for (const Json& window : json.at("windows"))
            block.windows.push_back(read_window(window, file.string(), scene));
        return block;
    } catch (const Json::exception& error) {
        throw InputError(file.string(), "", std::string("is no ") + format + ": " + error.what());
    }
}

}  // namespace flipside::lab::sweep

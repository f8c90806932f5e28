#pragma once
/// The options of all that draws.

#include <map>
#include <string>
#include <vector>

#include "app/cli/run_options.hpp"
#include "app/play.hpp"

namespace flipside::app {

/// `which` is the default, in words.
void add_view(CLI::App& command, auto& view, const std::string& which) {
    static const std::map<std::string, View> views{
        {"single", View::single}, {"split", View::split}, {"overlay", View::overlay}};
    const auto set = [&view](const std::string& name) { view = views.at(name); };
    command
        .add_option_function<std::string>("--view", set, "single, split or overlay (default " + which + ")")
        ->check(CLI::IsMember(std::vector<std::string>{"single", "split", "overlay"}))
        ->type_name("V");
}

void add_size(CLI::App& command, auto& width, auto& height) {
    command.add_option("--width", width, "px (default 1280)")
        ->check(whole_number_from(200, 8192))
        ->type_name("W");
    command.add_option("--height", height, "px (default 800)")
        ->check(whole_number_from(200, 8192))
        ->type_name("H");
}

}  // namespace flipside::app

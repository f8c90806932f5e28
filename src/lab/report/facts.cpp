#include "lab/report/facts.hpp"

#include <ctime>
#include <fstream>
#include <thread>

#include <nlohmann/json.hpp>
#include <sys/utsname.h>

#include "build_facts.hpp"
#include "lab/contenders/engines.hpp"

namespace flipside::lab::report {

namespace {

/// "model name" of the first processor.
std::string processor() {
    std::ifstream in("/proc/cpuinfo");
    for (std::string line; std::getline(in, line);)
        if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
    return "unknown processor";
}

std::string compiler() {
#ifdef __clang__
    return "clang " __clang_version__;
#else
    return "gcc " __VERSION__;
#endif
}

std::string json_version() {
    return std::to_string(NLOHMANN_JSON_VERSION_MAJOR) + "." + std::to_string(NLOHMANN_JSON_VERSION_MINOR) +
           "." + std::to_string(NLOHMANN_JSON_VERSION_PATCH);
}

}  // namespace

std::vector<std::pair<std::string, std::string>> build_facts() {
    utsname system{};
    uname(&system);
    return {{"Machine", processor() + ", " + std::to_string(std::thread::hardware_concurrency()) +
                            " hardware threads; every measurement runs on one"},
            {"System", std::string(system.sysname) + " " + system.release + ", " + system.machine},
            {"Compiler", compiler()},
            {"Flags", facts::flags},
            {"Libraries", libraries() + "; Boost " + facts::boost + ", nlohmann-json " + json_version()},
            {"Commit", facts::commit}};
}

std::string today() {
    const std::time_t now = std::time(nullptr);
    std::tm day{};
    gmtime_r(&now, &day);
    char text[16];
    std::strftime(text, sizeof text, "%Y-%m-%d", &day);
    return text;
}

}  // namespace flipside::lab::report

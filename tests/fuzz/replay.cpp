/// Runs a target over the files of the folders that are named, without libFuzzer: each in turn, until one
/// breaks.

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <vector>

#include "fuzz/target.hpp"
#include "world/json_file.hpp"

int main(int count, char** arguments) {
    namespace fs = std::filesystem;
    std::vector<fs::path> files;
    for (int i = 1; i < count; ++i)
        for (const fs::directory_entry& entry : fs::directory_iterator(arguments[i]))
            files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    for (const fs::path& file : files) {
        std::fprintf(stderr, "%s\n", file.c_str());
        flipside::fuzz::run_input(flipside::read_file(file));
    }
    if (files.empty()) std::fprintf(stderr, "there are no inputs\n");
    return files.empty() ? 1 : 0;
}

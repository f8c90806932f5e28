#pragma once
/// What --help says, as data: the man page and the completion of every shell are written from it.

#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace flipside::app {

/// What a shell may offer for a value.
enum class ValueKind {
    none,
    choice,
    scene,
    engine,
    engines,
    setting,
    engine_setting,
    lesson,
    hard_case,
    file,
    folder
};

struct OptionDescription {
    std::string name;   ///< "--engine" or "-h, --help"; of a positional the value's
    std::string value;  ///< "E"; "" for a flag
    std::string about;
    std::vector<std::string> notes;    ///< "required", "default 1", "not with --json"
    std::vector<std::string> choices;  ///< where the kind is choice
    ValueKind kind = ValueKind::none;
    bool positional = false;
    bool required = false;
    bool repeatable = false;
};

struct CommandDescription {
    std::string name, about, footer;
    std::vector<OptionDescription> options;
};

struct ProgramDescription {
    std::string version;
    CommandDescription general;  ///< the program without a command
    std::vector<CommandDescription> commands;
};

[[nodiscard]] ProgramDescription describe(const CLI::App& program);

}  // namespace flipside::app

#include "app/usage/description.hpp"

#include <algorithm>

#include <CLI/CLI.hpp>

namespace flipside::app {

namespace {

/// By the name of a value, as --help has it.
constexpr std::pair<std::string_view, ValueKind> kinds[] = {
    {"SCENE", ValueKind::scene},     {"E", ValueKind::engine},       {"ENGINE", ValueKind::engine},
    {"E,E,...", ValueKind::engines}, {"K=V", ValueKind::setting},    {"E.K=V", ValueKind::engine_setting},
    {"LESSON", ValueKind::lesson},   {"CASE", ValueKind::hard_case}, {"FILE", ValueKind::file},
    {"FILE.so", ValueKind::file},    {"CSV", ValueKind::file},       {"JSON", ValueKind::file},
    {"PNG", ValueKind::file},        {"STATE", ValueKind::file},     {"DIR", ValueKind::folder},
    {"DIR...", ValueKind::folder}};

/// CLI11 appends what a value is checked for, as in "V:{single,split}".
void read_value(OptionDescription& described, const std::string& type) {
    const auto colon = type.find(":{");
    described.value = type.substr(0, colon);
    if (colon != std::string::npos) {
        described.choices = CLI::detail::split(type.substr(colon + 2, type.size() - colon - 3), ',');
        described.kind = ValueKind::choice;
        return;
    }
    const auto* known =
        std::ranges::find(kinds, described.value, &std::pair<std::string_view, ValueKind>::first);
    if (known != std::end(kinds)) described.kind = known->second;
}

/// "-h, --help"
std::string every_name(const CLI::Option& option) {
    std::vector<std::string> names;
    for (const std::string& name : option.get_snames()) names.push_back("-" + name);
    for (const std::string& name : option.get_lnames()) names.push_back("--" + name);
    return CLI::detail::join(names, ", ");
}

std::string names_of(const std::set<CLI::Option*>& options) {
    std::vector<std::string> names;
    for (const CLI::Option* option : options) names.push_back(option->get_name());
    std::ranges::sort(names);  // the set is in the order of addresses
    return CLI::detail::join(names, ", ");
}

OptionDescription describe_option(const CLI::Option& option) {
    OptionDescription described;
    described.positional = option.get_positional();
    described.required = option.get_required();
    described.repeatable = option.get_expected_max() > 1;
    described.about = option.get_description();
    if (option.get_type_size() != 0) read_value(described, option.get_type_name());
    described.name = described.positional ? described.value : every_name(option);
    if (described.required) described.notes.emplace_back("required");
    if (!option.get_default_str().empty()) described.notes.push_back("default " + option.get_default_str());
    if (!option.get_needs().empty()) described.notes.push_back("needs " + names_of(option.get_needs()));
    if (!option.get_excludes().empty())
        described.notes.push_back("not with " + names_of(option.get_excludes()));
    return described;
}

CommandDescription describe_command(const CLI::App& command) {
    CommandDescription described{command.get_name(), command.get_description(), command.get_footer(), {}};
    // What --help of every command ends with is the program's own
    if (command.get_parent() != nullptr && described.footer == command.get_parent()->get_footer())
        described.footer.clear();
    for (const CLI::Option* option : command.get_options())
        described.options.push_back(describe_option(*option));
    return described;
}

}  // namespace

ProgramDescription describe(const CLI::App& program) {
    ProgramDescription described{program.version(), describe_command(program), {}};
    for (const CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; }))
        described.commands.push_back(describe_command(*command));
    return described;
}

}  // namespace flipside::app

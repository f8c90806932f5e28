/// The one executable: reads the command line, runs what it asks for, turns errors into exit codes.
/// 0: done. 1: what was asked could not be done. 2: bad usage or bad input.

#include <algorithm>

#include "app/cli/commands.hpp"
#include "app/cli/exit_code.hpp"
#include "app/cli/interrupt.hpp"
#include "app/cli/output.hpp"
#include "lab/files/assets.hpp"
#include "lab/files/text_stream.hpp"
#include "plugin/worker.hpp"
#include "world/input_error.hpp"

namespace {

using namespace flipside;

std::string names_of(const std::vector<const CLI::App*>& commands) {
    std::string names;
    for (const CLI::App* command : commands) names += (names.empty() ? "" : ", ") + command->get_name();
    return names;
}

/// The command may be left out: what does not begin with one is for the window.
std::vector<std::string> with_command(const CLI::App& program, std::vector<std::string> arguments) {
    const auto commands = program.get_subcommands([](const CLI::App*) { return true; });
    if (!arguments.empty()) {
        const std::string& first = arguments.front();
        const bool general = first == "-h" || first == "--help" || first == "--version";
        if (general || std::ranges::find(commands, first, &CLI::App::get_name) != commands.end())
            return arguments;
        if (!first.starts_with('-')) {
            try {
                static_cast<void>(lab::scene_file(first));
            } catch (const InputError& error) {
                throw InputError("no command '" + first + "' (there are " + names_of(commands) + ") and " +
                                 error.what());
            }
        }
    }
    arguments.insert(arguments.begin(), "play");
    return arguments;
}

/// An empty word, as an unset variable of a shell gives one, would count as an option that is not there.
void require_words(const std::vector<std::string>& arguments) {
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const bool is_option = arguments[i].starts_with("--");
        if (arguments[i].empty() || (is_option && arguments[i].ends_with('=')))
            throw InputError("argument " + std::to_string(i + 1) + " is empty" +
                             (i > 0 || is_option ? " (" + arguments[is_option ? i : i - 1] + ")" : "") +
                             "; allowed are arguments with a text");
    }
}

bool has_empty_item(const std::string& list, char delimiter) {
    return list.starts_with(delimiter) || list.ends_with(delimiter) ||
           list.find({delimiter, delimiter}) != std::string::npos;
}

/// CLI11 leaves empty items of lists out. `arguments` begin with the command.
void require_items(const CLI::App& program, const std::vector<std::string>& arguments) {
    const auto named = program.get_subcommands(
        [&](const CLI::App* command) { return command->get_name() == arguments.front(); });
    if (named.empty()) return;
    const CLI::Option* option = nullptr;  // whose values come
    for (const std::string& argument : arguments) {
        std::string value = argument;
        if (argument.starts_with("--")) {
            const std::size_t equals = argument.find('=');
            option = named.front()->get_option_no_throw(argument.substr(0, equals));
            value = equals == std::string::npos ? "" : argument.substr(equals + 1);
        }
        if (option == nullptr || value.empty()) continue;
        const char delimiter = option->get_delimiter();
        if (delimiter != '\0' && has_empty_item(value, delimiter))
            throw InputError(option->get_name() + ": '" + value +
                             "' has an empty item; allowed are items with a text, as A,B");
        if (!option->get_allow_extra_args()) option = nullptr;
    }
}

/// Sets `chosen` to what the arguments ask for; --help and --version among them.
void parse(CLI::App& program, app::Action& chosen, std::vector<std::string> arguments) {
    require_words(arguments);
    try {
        arguments = with_command(program, std::move(arguments));
        require_items(program, arguments);
        std::ranges::reverse(arguments);  // as CLI11 takes them
        program.parse(arguments);
    } catch (const CLI::Success& asked) {
        lab::TextStream text;
        program.exit(asked, text, text);
        chosen = [words = text.str()] {
            app::print_text(words);
            return 0;
        };
    } catch (const CLI::ParseError& error) {
        throw InputError(error.what());
    }
}

/// Reads the command line and does what it asks for.
int command_line(int argc, char** argv) {
    CLI::App program("One pinball table, two interchangeable 2D physics engines, side by side.", "flipside");
    program.set_version_flag("--version", FLIPSIDE_VERSION);
    program.footer(
        "Without a command the window opens. `flipside COMMAND --help` says more about a command.\n"
        "Exit codes: 0 done, 1 could not be done, 2 bad usage or bad input.");
    app::Action chosen;
    app::add_play(program, chosen);
    app::add_run(program, chosen);
    app::add_bot(program, chosen);
    app::add_compare(program, chosen);
    app::add_certify(program, chosen);
    app::add_trace(program, chosen);
    app::add_lessons(program, chosen);
    app::add_cases(program, chosen);
    app::add_pairs(program, chosen);
    app::add_sweep(program, chosen);
    app::add_hunt(program, chosen);
    app::add_report(program, chosen);
    app::add_replay(program, chosen);
    app::add_render(program, chosen);
    app::add_scenes(program, chosen);
    app::add_engines(program, chosen);
    app::add_check(program, chosen);
    app::add_conformance(program, chosen);
    app::add_manual(program, FLIPSIDE_RELEASED, chosen);
    app::add_completion(program, chosen);
    parse(program, chosen, {argv + 1, argv + argc});
    return chosen();
}

}  // namespace

int main(int argc, char** argv) {
    if (plugin::is_engine_process(argc, argv)) plugin::run_engine_process(argv[2]);
    app::prepare_streams();
    app::end_on_interrupts();
    return app::exit_code_of([=] { return command_line(argc, argv); });
}

#include "app/cli/commands.hpp"
#include "app/cli/output.hpp"
#include "app/usage/completion.hpp"
#include "app/usage/manual_page.hpp"

namespace flipside::app {

void add_manual(CLI::App& program, const std::string& released, Action& chosen) {
    program.add_subcommand("manual", "Print the man page: `flipside manual | man -l -` shows it")
        ->callback([&program, released, &chosen] {
            chosen = [&program, released] {
                print_text(manual_page(describe(program), released));
                return 0;
            };
        });
}

void add_completion(CLI::App& program, Action& chosen) {
    CLI::App& command = *program.add_subcommand(
        "completion", "Print a script that completes commands, options, scenes and settings in a shell");
    // There is one shell, so nothing depends on which it is.
    command
        .add_option_function<std::string>(
            "shell", [](const std::string&) {}, "The shell; for bash: `source <(flipside completion bash)`")
        ->required()
        ->check(CLI::IsMember(std::vector<std::string>{"bash"}))
        ->type_name("SHELL");
    command.callback([&program, &chosen] {
        chosen = [&program] {
            print_text(bash_completion(describe(program)));
            return 0;
        };
    });
}

}  // namespace flipside::app

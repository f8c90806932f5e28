/// The one executable: reads the command line, runs what it asks for, turns errors into exit codes.
/// 0: done. 1: what was asked could not be done. 2: bad usage or bad input.

#include <algorithm>
#include <exception>
#include <iostream>

#include "app/cli/commands.hpp"
#include "world/input_error.hpp"

namespace {

using namespace flipside;

int fail(int code, std::string message) {
    std::ranges::replace(message, '\n', ' ');
    std::cerr << "flipside: " << message << '\n';
    return code;
}

int act(const app::Action& action) {
    try {
        return action();
    } catch (const InputError& error) {
        return fail(2, error.what());
    } catch (const std::exception& error) {
        return fail(1, error.what());
    }
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App program("One pinball table, two interchangeable 2D physics engines, side by side.", "flipside");
    program.set_version_flag("--version", FLIPSIDE_VERSION);
    program.require_subcommand(1);
    program.footer(
        "Exit codes: 0 done, 1 could not be done, 2 bad usage or bad input.\n"
        "`flipside COMMAND --help` says more about a command.");
    app::Action chosen;
    app::add_run(program, chosen);
    app::add_compare(program, chosen);
    app::add_scenes(program, chosen);
    app::add_engines(program, chosen);
    app::add_check(program, chosen);
    try {
        program.parse(argc, argv);
    } catch (const CLI::Success& asked) {  // --help, --version
        return program.exit(asked);
    } catch (const CLI::ParseError& error) {
        return fail(2, error.what());
    }
    return act(chosen);
}

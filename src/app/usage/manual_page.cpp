#include "app/usage/manual_page.hpp"

#include <algorithm>

#include "lab/files/text_stream.hpp"

namespace flipside::app {

namespace {

/// Text that troff takes as it is: no escapes, no request at the beginning of a line, and a hyphen that is
/// one when it is copied into a shell.
std::string plain_roff(std::string_view text) {
    std::string safe;
    for (const char c : text) {
        const bool line_begins = safe.empty() || safe.back() == '\n';
        if (line_begins && (c == '.' || c == '\'')) safe += "\\&";
        switch (c) {
            case '\\':
                safe += "\\e";
                break;
            case '-':
                safe += "\\-";
                break;
            case '`':  // `flipside scenes` is in bold instead
                break;
            default:
                safe += c;
        }
    }
    return safe;
}

/// What stands between backquotes is in bold.
std::string roff(std::string_view text) {
    std::string marked;
    bool bold = false;
    while (true) {
        const auto quote = text.find('`');
        marked += plain_roff(text.substr(0, quote));
        if (quote == std::string_view::npos) return marked;
        bold = !bold;
        marked += bold ? "\\fB" : "\\fR";
        text.remove_prefix(quote + 1);
    }
}

std::string quoted(const std::string& text) {
    return "\"" + plain_roff(text) + "\"";
}

/// A sentence that begins in upper case and has no full stop, as --help has them.
std::string sentence(const std::string& text) {
    return roff(text) + (text.ends_with('.') ? "\n" : ".\n");
}

/// `--engine E`, or `[--engine E]...`
std::string synopsis(const OptionDescription& option) {
    std::string words = "\\fB" + plain_roff(option.name) + "\\fR";
    if (option.positional)
        words = "\\fI" + plain_roff(option.value) + "\\fR";
    else if (!option.value.empty())
        words += "\\~\\fI" + plain_roff(option.value) + "\\fR";
    if (!option.required) words = "[" + words + "]";
    return words + (option.repeatable ? "\\&..." : "");
}

void write_option(lab::TextStream& page, const OptionDescription& option) {
    page << ".TP\n";
    if (option.positional)
        page << ".I " << quoted(option.value) << '\n';
    else if (option.value.empty())
        page << ".B " << quoted(option.name) << '\n';
    else
        page << ".BI " << quoted(option.name + " ") << ' ' << quoted(option.value) << '\n';
    page << roff(option.about);
    std::string notes;
    for (const std::string& note : option.notes) notes += (notes.empty() ? "" : "; ") + roff(note);
    if (!option.choices.empty()) {
        notes += notes.empty() ? "one of" : "; one of";
        for (const std::string& choice : option.choices) notes += " \\fB" + plain_roff(choice) + "\\fR";
    }
    page << (notes.empty() ? ".\n" : " (" + notes + ").\n");
}

void write_command(lab::TextStream& page, const CommandDescription& command) {
    page << ".SS " << quoted("flipside " + command.name) << '\n'
         << ".B " << quoted("flipside " + command.name) << '\n';
    // Positionals last, as one may write them
    for (const bool positional : {true, false})
        for (const OptionDescription& option : command.options)
            if (option.positional == positional) page << synopsis(option) << '\n';
    page << ".PP\n" << sentence(command.about);
    if (!command.footer.empty()) page << ".PP\n" << sentence(command.footer);
    for (const OptionDescription& option : command.options) write_option(page, option);
}

constexpr std::string_view end_of_page = R"(.SH ENVIRONMENT
.TP
.B FLIPSIDE_ASSETS
The folder of scenes and lessons, instead of the one that was installed with the program.
.TP
.BR XDG_STATE_HOME ", " HOME
Where the window keeps what was on show, in
.IR flipside/window.json ,
and the high scores, in
.IR flipside/scores.json ;
without XDG_STATE_HOME in
.IR ~/.local/state .
.TP
.B DISPLAY
The X server of
.B play
and
.BR render .
.SH FILES
Scenes, scripts, states and lessons are JSON;
.I ../share/flipside/*.schema.json
beside the program's folder describe them.
.SH SEE ALSO
.BR flipside_check_certificate (1),
.BR xvfb\-run (1)
)";

}  // namespace

std::string manual_page(const ProgramDescription& program, const std::string& date) {
    lab::TextStream page;
    const std::string& name = program.general.name;
    page << ".\\\" Written by `" << name << " manual`.\n"
         << ".TH FLIPSIDE 1 " << date << ' ' << quoted(name + " " + program.version)
         << " \"User Commands\"\n.SH NAME\n"
         << name << " \\- two physics engines side by side on one pinball table\n"
         << ".SH SYNOPSIS\n.B flipside\n[\\fICOMMAND\\fR] [\\fIARGUMENTS\\fR]\n"
         << ".SH DESCRIPTION\n"
         << sentence(program.general.about);
    // One paragraph for each line of the footer
    for (std::string_view rest = program.general.footer; !rest.empty();) {
        const auto end = std::min(rest.find('\n'), rest.size());
        page << ".PP\n" << sentence(std::string(rest.substr(0, end)));
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    page << ".SH OPTIONS\n";
    for (const OptionDescription& option : program.general.options) write_option(page, option);
    page << ".SH COMMANDS\n";
    for (const CommandDescription& command : program.commands) write_command(page, command);
    page << end_of_page;
    return page.str();
}

}  // namespace flipside::app

#include <algorithm>
#include <map>

#include "app/usage/completion.hpp"
#include "lab/files/text_stream.hpp"

namespace flipside::app {

namespace {

/// How the script below calls what an option takes.
std::string kind_in_bash(const OptionDescription& option) {
    switch (option.kind) {
        case ValueKind::none:
            return "none";
        case ValueKind::scene:
            return "scene";
        case ValueKind::engine:
            return "engine";
        case ValueKind::engines:
            return "engines";
        case ValueKind::setting:
            return "setting";
        case ValueKind::engine_setting:
            return "engine_setting";
        case ValueKind::lesson:
            return "lesson";
        case ValueKind::hard_case:
            return "case";
        case ValueKind::file:
            return "file";
        case ValueKind::folder:
            return "folder";
        case ValueKind::choice:
            break;
    }
    std::string words = "choice";
    for (const std::string& choice : option.choices) words += ' ' + choice;
    return words;
}

/// Patterns "COMMAND OPTION" by the kind of value; a positional is the option "".
std::map<std::string, std::string> patterns_by_kind(const ProgramDescription& program) {
    std::map<std::string, std::string> patterns;
    for (const CommandDescription& command : program.commands)
        for (const OptionDescription& option : command.options) {
            if (option.value.empty()) continue;
            std::string& pattern = patterns[kind_in_bash(option)];
            pattern += (pattern.empty() ? "'" : " | '") + command.name + ' ' +
                       (option.positional ? "" : option.name) + "'";
        }
    return patterns;
}

/// "-h, --help" is two words.
std::string words_of(const CommandDescription& command) {
    std::string words;
    for (const OptionDescription& option : command.options) {
        if (option.positional) continue;
        if (!words.empty()) words += ' ';
        std::ranges::copy_if(option.name, std::back_inserter(words), [](char c) { return c != ','; });
    }
    return words;
}

constexpr std::string_view engine_of_the_script = R"script(
# Prints what may stand for a value of kind $1 that begins with $2, a line each; $3 is the program.
_flipside_values() {
    local begun=$2 list='' engine
    case $1 in
        choice*) list=${1#choice} ;;
        scene) list=$("$3" scenes 2>/dev/null | sed -n '/^[^ ]/p') ;;
        engine | engines) list=$("$3" engines 2>/dev/null | sed -n 's/^\([^ :]*\): .*/\1/p') ;;
        lesson) list=$("$3" lessons 2>/dev/null | sed -n 's/^\([^ ]*\) .*/\1/p') ;;
        case) list=$("$3" cases --list 2>/dev/null | awk '{ print $2 }') ;;
        setting) list=$("$3" engines $_flipside_engine 2>/dev/null | _flipside_settings '' "$begun") ;;
        engine_setting) list=$("$3" engines 2>/dev/null | _flipside_settings . "$begun") ;;
        folder) compgen -d -- "$begun" ;;
    esac
    if [[ $1 == engines && $begun == *,* ]]; then
        compgen -P "${begun%,*}," -W "$list" -- "${begun##*,}"
    else
        compgen -W "$list" -- "$begun"
    fi
    case $1 in scene | engine | lesson | file) compgen -f -- "$begun" ;; esac
}

# From what `flipside engines` prints: KEY= of every setting, or KEY=VALUE once there is a '=' in $2. With $1 '.' keys are
# ENGINE.KEY.
_flipside_settings() {
    awk -v dot="$1" -v begun="$2" '
        /^[^ ]/ { engine = dot; if (dot != "") { sub(/:.*/, ""); engine = $0 dot } }
        /^  [^ ]/ {
            key = engine $1 "="
            if (index(begun, "=") == 0) { print key; next }
            if (index(begun, key) != 1 || !match($0, /\([^)]*\)/)) next
            values = substr($0, RSTART + 1, RLENGTH - 2)
            if (values ~ / to /) next
            count = split(values, value, ", ")
            for (i = 1; i <= count; ++i) print key value[i]
        }'
}

_flipside() {
    local program=${1/#\~/$HOME} IFS=$' \t\n' words=() word i
    # Bash splits --engine=custom and solver=simple at the '='; here these are one word.
    for ((i = 1; i <= COMP_CWORD; ++i)); do
        word=${COMP_WORDS[i]}
        if ((${#words[@]})) && [[ $word == = || ${words[-1]} == *= ]]; then
            words[-1]+=$word
        else
            words+=("$word")
        fi
    done
    local current=${words[-1]} previous='' command=play _flipside_engine='' options kind
    ((${#words[@]} > 1)) && previous=${words[-2]} && _flipside_is_command "${words[0]}" && command=${words[0]}
    for ((i = 0; i + 1 < ${#words[@]}; ++i)); do
        [[ ${words[i]} == --engine ]] && _flipside_engine=${words[i + 1]}
        [[ ${words[i]} == --engine=* ]] && _flipside_engine=${words[i]#*=}
    done

    _flipside_options "$command"
    _flipside_kind "$command $previous"
    if [[ $previous == --* && $kind != flag ]]; then
        mapfile -t COMPREPLY < <(_flipside_values "$kind" "$current" "$program")
    elif [[ $current == --*=* ]]; then
        _flipside_kind "$command ${current%%=*}"
        mapfile -t COMPREPLY < <(_flipside_values "$kind" "${current#*=}" "$program")
        COMPREPLY=("${COMPREPLY[@]/#/${current%%=*}=}")
    elif [[ $current == -* ]]; then
        ((${#words[@]} == 1)) && options+=" $_flipside_general"
        mapfile -t COMPREPLY < <(compgen -W "$options" -- "$current")
        return
    else
        _flipside_kind "$command "
        mapfile -t COMPREPLY < <(
            ((${#words[@]} == 1)) && compgen -W "$_flipside_commands" -- "$current"
            _flipside_values "$kind" "$current" "$program"
        )
    fi
    [[ $kind =~ ^(scene|engine|lesson|file|folder)$ ]] && compopt -o filenames
    [[ ${#COMPREPLY[@]} == 1 && ${COMPREPLY[0]} == *= ]] && compopt -o nospace
    # What comes before the last '=' is a word of its own to bash.
    if [[ $current == *=* && $COMP_WORDBREAKS == *=* ]]; then
        COMPREPLY=("${COMPREPLY[@]#"${current%=*}="}")
    fi
}
complete -F _flipside flipside
)script";

}  // namespace

std::string bash_completion(const ProgramDescription& program) {
    lab::TextStream script;
    std::string commands, alternatives;
    for (const CommandDescription& command : program.commands) {
        commands += (commands.empty() ? "" : " ") + command.name;
        alternatives += (alternatives.empty() ? "" : " | ") + command.name;
    }
    script << "# Completion of flipside for bash, written by `flipside completion bash`.\n\n"
           << "_flipside_commands='" << commands << "'\n"
           << "_flipside_general='" << words_of(program.general) << "'\n"
           << "_flipside_is_command() { case $1 in " << alternatives << ") ;; *) false ;; esac; }\n\n"
           << "# Sets options: those of command $1.\n_flipside_options() {\n    case $1 in\n";
    for (const CommandDescription& command : program.commands)
        script << "        " << command.name << ") options='" << words_of(command) << "' ;;\n";
    script << "    esac\n}\n\n"
           << "# Sets kind: what value \"COMMAND OPTION\" takes; flag where it takes none.\n_flipside_kind() "
              "{\n    case $1 in\n";
    for (const auto& [kind, patterns] : patterns_by_kind(program))
        script << "        " << patterns << ") kind='" << kind << "' ;;\n";
    script << "        *) kind=flag ;;\n    esac\n}\n" << engine_of_the_script;
    return script.str();
}

}  // namespace flipside::app

// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "hmi/manual/shell_completion.hpp"
#include "hmi/manual/value_completion.hpp"

namespace psicarve::manual {
namespace {

/// FUNCTION stands for the function's name. Bash splits --option=value at =, and ball:3 at the colon.
constexpr const char* kBashHead = R"(FUNCTION_files() {
    local ending
    # Words are not quoted as names are.
    if ((${#COMPREPLY[@]} == 0)); then compopt -o filenames 2>/dev/null; fi
    mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(
        compgen -d -- "$cur"
        for ending; do compgen -f -X "!*.$ending" -- "$cur"; compgen -f -X "!*.${ending^^}" -- "$cur"; done)
}
FUNCTION_words() {
    mapfile -t COMPREPLY < <(compgen -W "$1" -- "$cur")
    if ((${#COMPREPLY[@]} == 1)) && [[ ${COMPREPLY[0]} == *[=:] ]]; then compopt -o nospace 2>/dev/null; fi
}
FUNCTION() {
    local cur=${COMP_WORDS[COMP_CWORD]} previous='' command='' position=0 value='' i word
    COMPREPLY=()
    if ((COMP_CWORD > 0)); then previous=${COMP_WORDS[COMP_CWORD - 1]}; fi
    if [[ $cur == [=:] || $previous == [=:] ]]; then value=1; fi
    if [[ $cur == '=' ]]; then
        cur=''
    elif [[ $previous == '=' ]]; then
        previous=${COMP_WORDS[COMP_CWORD - 2]}
    fi
)";

constexpr const char* kBashWalk = R"(    for ((i = 1; i < COMP_CWORD; ++i)); do
        word=${COMP_WORDS[i]}
        case "$word" in
            [=:]) ((++i)) ;;
            --) previous='' ;;
            -*)
                case "$command:$word" in
VALUES                        if [[ ${COMP_WORDS[i + 1]} != '=' ]]; then ((++i)); fi ;;
                esac ;;
            *)
                case "$command $word" in
COMMANDS                    *) ((++position)) ;;
                esac ;;
        esac
    done
)";

std::string function_of(const std::string& program) {
    std::string name = "_" + program;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size()))
        text.replace(at, what.size(), by);
    return text;
}

std::string bash_action(const ValueCompletion& completion, const std::string& function) {
    if (completion.groups) return "mapfile -t COMPREPLY < <(compgen -g -- \"$cur\")";
    if (completion.users) return "mapfile -t COMPREPLY < <(compgen -u -- \"$cur\")";
    if (completion.any_file)
        return "compopt -o filenames 2>/dev/null; mapfile -t COMPREPLY < <(compgen -f -- \"$cur\")";
    std::string action;
    if (!completion.words.empty()) action = function + "_words '" + joined(completion.words, " ") + "'";
    if (completion.endings.empty()) return action.empty() ? ":" : action;
    return (action.empty() ? "" : action + "; ") + function + "_files " + joined(completion.endings, " ");
}

/// Labels of a `case`, all with one answer.
class Cases {
public:
    void add(const std::string& label, const std::string& action) {
        auto& labels = labels_[action];
        if (labels.empty()) actions_.push_back(action);
        labels.push_back(label);
    }
    std::string text() const {
        std::string text;
        for (const std::string& action : actions_)
            text += "        " + joined(labels_.at(action), " | ") + ") " + action + " ;;\n";
        return text;
    }

private:
    std::vector<std::string> actions_;  ///< in the order in which they came
    std::map<std::string, std::vector<std::string>> labels_;
};

std::string quoted(const std::string& text) {
    return "'" + text + "'";
}

struct BashParts {
    std::vector<std::string> values;    ///< labels of options that have one
    std::vector<std::string> commands;  ///< "slice", "snapshot", "snapshot save"
    Cases of_options, of_arguments, option_names;
};

void take_command(const PlacedCommand& placed, const std::string& function, BashParts& parts) {
    const std::string command = joined(placed.words, " ", 1);
    if (!command.empty()) parts.commands.push_back(command);
    std::string names;
    for (const OptionRow& option : placed.table->options) {
        for (const std::string& name : option.names) {
            names += (names.empty() ? "" : " ") + name;
            if (!takes_value(option)) continue;
            const std::string label = quoted(labelled(command, name));
            parts.values.push_back(label);
            parts.of_options.add(label, bash_action(completion_of(option), function));
        }
    }
    parts.option_names.add(quoted(command), function + "_words '" + names + "'");
    std::vector<std::string> below;
    for (const CommandTable& table : placed.table->commands) below.push_back(table.name);
    if (!below.empty())
        parts.of_arguments.add(quoted(command + ":0"), function + "_words '" + joined(below, " ") + "'");
    const auto& arguments = placed.table->arguments;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const std::string place = quoted(command + ":" + (arguments[i].is_repeated ? "" : std::to_string(i)));
        parts.of_arguments.add(place + (arguments[i].is_repeated ? "*" : ""),
                               bash_action(completion_of(arguments[i], placed.words), function));
    }
}

/// The command that has been reached is the command before and the word.
std::string command_cases(const std::vector<std::string>& commands) {
    std::string text;
    for (const std::string& command : commands) {
        const bool is_first = command.find(' ') == std::string::npos;
        text += "                    " + quoted(is_first ? " " + command : command) +
                ") command=" + quoted(command) + " ;;\n";
    }
    return text;
}

std::string value_labels(const std::vector<std::string>& values) {
    std::string text = "                    ";
    for (std::size_t i = 0; i < values.size(); ++i) {
        text += values[i] + (i + 1 < values.size() ? " |" : ")");
        text += (i + 1 < values.size() && i % 4 == 3) ? " \\\n                        "
                : i + 1 < values.size()               ? " "
                                                      : "\n";
    }
    return text;
}

}  // namespace

std::string bash_completion(const CommandTable& program) {
    const std::string function = function_of(program.name);
    BashParts parts;
    for (const PlacedCommand& placed : all_commands(program)) take_command(placed, function, parts);
    std::string walk = replaced(kBashWalk, "COMMANDS", command_cases(parts.commands));
    walk = replaced(walk, "VALUES", value_labels(parts.values));
    return "# bash completion for " + program.name + "\n# shellcheck shell=bash disable=SC2034\n" +
           replaced(kBashHead, "FUNCTION", function) + walk + "    case \"$command:$previous\" in\n" +
           replaced(parts.of_options.text(), " ;;\n", "; return ;;\n") + "    esac\n" +
           "    if [[ -n $value ]]; then return; fi\n    if [[ $cur == -* ]]; then\n        case "
           "\"$command\" in\n" +
           parts.option_names.text() +
           "        esac\n        return\n    fi\n    case \"$command:$position\" in\n" +
           parts.of_arguments.text() + "    esac\n}\ncomplete -F " + function + " " + program.name + "\n";
}

}  // namespace psicarve::manual

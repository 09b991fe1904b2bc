// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "hmi/manual/shell_completion.hpp"
#include "hmi/manual/value_completion.hpp"

namespace psicarve::manual {
namespace {

/// In a specification of _arguments, which stands in single quotes.
std::string zsh_text(const std::string& text) {
    std::string result;
    for (const char c : text) {
        if (c == '\'') {
            result += "'\\''";
        } else {
            if (c == '[' || c == ']' || c == ':' || c == '\\') result += '\\';
            result += c;
        }
    }
    return result;
}

std::string in_quotes(const std::string& text) {
    std::string result;
    for (const char c : text) result += c == '\'' ? "'\\''" : std::string{c};
    return result;
}

std::string zsh_function(const std::vector<std::string>& words) {
    std::string name = "_" + joined(words, "_");
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}

/// A single ending in parentheses at the end would be a qualifier of the files.
std::string zsh_pattern(const std::vector<std::string>& endings) {
    const std::string all = joined(endings, "|");
    return "*.(#i)" + (endings.size() == 1 ? all : "(" + all + ")");
}

/// The text behind the second colon of a specification.
std::string zsh_action(const ValueCompletion& completion) {
    if (completion.groups) return "_groups";
    if (completion.users) return "_users";
    if (completion.any_file) return "_files";
    std::string files;
    if (!completion.endings.empty()) files = "_files -g \"" + zsh_pattern(completion.endings) + "\"";
    if (completion.words.empty()) return files.empty() ? " " : files;
    const bool is_open = std::any_of(completion.words.begin(), completion.words.end(), goes_on);
    const std::string words = zsh_text(joined(completion.words, " "));
    if (!is_open && files.empty()) return "(" + words + ")";
    return std::string{"{compadd "} + (is_open ? "-S \"\" " : "") + "-- " + words +
           (files.empty() ? "}" : "; _wanted files expl file " + files + "}");
}

std::string option_specifications(const OptionRow& option) {
    std::string all;
    const std::string excluded = option.is_repeated ? "*" : "(" + joined(option.names, " ") + ")";
    for (const std::string& name : option.names) {
        const bool is_long = name.size() > 1 && name[1] == '-';
        all.append(" \\\n        '").append(excluded).append(name);
        all.append(takes_value(option) && is_long ? "=[" : "[").append(zsh_text(option.help)).append("]");
        if (takes_value(option)) all += ":" + zsh_text(option.type) + ":" + zsh_action(completion_of(option));
        all += "'";
    }
    return all;
}

std::string zsh_command(const PlacedCommand& placed) {
    const CommandTable& table = *placed.table;
    const bool has_commands = !table.commands.empty();
    std::string text = zsh_function(placed.words) + "() {\n";
    if (has_commands)
        text += "    local curcontext=\"$curcontext\" state state_descr line\n    typeset -A opt_args\n";
    text += has_commands ? "    _arguments -C -s -S" : "    _arguments -s -S";
    for (const OptionRow& option : table.options) text += option_specifications(option);
    for (const ArgumentRow& argument : table.arguments) {
        const std::string head = argument.is_repeated ? "*:" : argument.is_required ? ":" : "::";
        text += " \\\n        '" + head + zsh_text(argument.name) + ":" +
                zsh_action(completion_of(argument, placed.words)) + "'";
    }
    if (!has_commands) return text + "\n}\n";
    text += " \\\n        '1:command:->command' \\\n        '*::argument:->argument'\n    case $state in\n";
    text += "    command)\n        local -a commands=(";
    for (const CommandTable& below : table.commands)
        text += "\n            '" + below.name + ":" + in_quotes(below.summary) + "'";
    text = text + "\n        )\n        _describe command commands ;;\n" +
           "    argument)\n        case $line[1] in\n";
    for (const CommandTable& below : table.commands) {
        std::vector<std::string> words = placed.words;
        words.push_back(below.name);
        text += "        " + below.name + ") " + zsh_function(words) + " ;;\n";
    }
    return text + "        esac ;;\n    esac\n}\n";
}

}  // namespace

std::string zsh_completion(const CommandTable& program) {
    std::string text = "#compdef " + program.name + "\n";
    for (const PlacedCommand& placed : all_commands(program)) text += zsh_command(placed);
    const std::string function = zsh_function({program.name});
    // The file is the function when zsh loads it by itself, and defines it when it is sourced.
    return text + "if [[ $funcstack[1] == _" + program.name + " ]]; then " + function +
           " \"$@\"; else compdef " + function + " " + program.name + "; fi\n";
}

}  // namespace psicarve::manual

// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "hmi/manual/shell_completion.hpp"
#include "hmi/manual/value_completion.hpp"

namespace psicarve::manual {
namespace {

/// NAME stands for the functions' name. They print the command on the line, and how many arguments come after
/// it.
constexpr const char* kFishHead = R"(function __NAME_place
    set -l command ''
    set -l count 0
    set -l skips no
    for word in (commandline -opc)[2..]
        if test $skips = yes
            set skips no
            continue
        end
        if contains -- "$command:$word" VALUES
            set skips yes
        else if not string match -q -- '-*' $word
            set -l longer (string trim -- "$command $word")
            if contains -- $longer COMMANDS
                set command $longer
            else
                set count (math $count + 1)
            end
        end
    end
    echo $command
    echo $count
end
function __NAME_at
    set -l place (__NAME_place)
    test "$place[1]" = "$argv[1]"; or return 1
    test (count $argv) = 1; or test $place[2] = $argv[2]
end
function __NAME_files
    set -l typed (commandline -ct | string replace -r -- '^--[^=]*=' '')
    # Fish's own names of files know ~, $HOME, quotes and backslashes.
    for file in (complete -C "__fish_command_without_completions $typed")
        set -l path (string split -f1 \t -- $file)
        if string match -qri -- "(/|\\.($argv[1]))\$" $path
            echo $path
        end
    end
end
)";

std::string fish_text(const std::string& text) {
    std::string result = "'";
    for (const char c : text) {
        if (c == '\'' || c == '\\') result += '\\';
        result += c;
    }
    return result + "'";
}

std::string with(std::string text, const std::string& what, const std::string& by) {
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size()))
        text.replace(at, what.size(), by);
    return text;
}

/// The options of `complete` that say which words there are: of several -a it takes the last alone.
std::string fish_words(const ValueCompletion& completion, const std::string& function) {
    std::vector<std::string> all = completion.words;
    if (completion.groups) all.emplace_back("(__fish_complete_groups)");
    if (completion.users) all.emplace_back("(__fish_complete_users)");
    // Fish takes what is behind the = of key=value for the beginning of a name.
    const std::string unless =
        completion.words.empty() ? "" : "string match -q '*=*' -- (commandline -ct); or ";
    if (!completion.endings.empty())
        all.push_back("(" + unless + function + "_files '" + joined(completion.endings, "|") + "')");
    return (all.empty() ? "" : " -a " + fish_text(joined(all, " "))) + (completion.any_file ? " -F" : "");
}

std::string fish_option(const OptionRow& option, const std::string& function) {
    std::string text;
    for (const std::string& name : option.names) {
        const bool is_long = name.size() > 1 && name[1] == '-';
        text += is_long ? " -l " + name.substr(2) : " -s " + name.substr(1);
    }
    if (takes_value(option)) {
        const ValueCompletion completion = completion_of(option);
        text += (completion.any_file ? " -r" : " -x") + fish_words(completion, function);
    }
    return text + " -d " + fish_text(option.help);
}

std::string fish_command(const PlacedCommand& placed, const std::string& head, const std::string& function) {
    const CommandTable& table = *placed.table;
    const std::string command = joined(placed.words, " ", 1);
    const auto at = [&](const std::string& place) {
        return " -n " + fish_text(function + "_at '" + command + "'" + place);
    };
    std::string text;
    for (const CommandTable& below : table.commands)
        text += head + at(" 0") + " -a " + below.name + " -d " + fish_text(below.summary) + "\n";
    for (const OptionRow& option : table.options)
        text.append(head).append(at("")).append(fish_option(option, function)).append("\n");
    for (std::size_t i = 0; i < table.arguments.size(); ++i) {
        const ArgumentRow& argument = table.arguments[i];
        const std::string words = fish_words(completion_of(argument, placed.words), function);
        if (!words.empty())
            text.append(head)
                .append(at(argument.is_repeated ? "" : " " + std::to_string(i)))
                .append(words)
                .append("\n");
    }
    return text;
}

}  // namespace

std::string fish_completion(const CommandTable& program) {
    std::string name = program.name;
    std::replace(name.begin(), name.end(), '-', '_');
    std::string values, commands, rules;
    for (const PlacedCommand& placed : all_commands(program)) {
        const std::string command = joined(placed.words, " ", 1);
        if (!command.empty()) commands += " " + fish_text(command);
        for (const OptionRow& option : placed.table->options) {
            for (const std::string& option_name : option.names)
                if (takes_value(option)) values += " " + fish_text(labelled(command, option_name));
        }
        rules += fish_command(placed, "complete -c " + program.name, "__" + name);
    }
    const std::string functions =
        with(with(with(kFishHead, "NAME", name), " COMMANDS", commands), " VALUES", values);
    return "# fish completion for " + program.name + "\n" + functions + "complete -c " + program.name +
           " -f\n" + rules;
}

}  // namespace psicarve::manual

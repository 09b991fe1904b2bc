// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace psicarve::manual {

struct OptionRow {
    std::vector<std::string> names;  ///< "-o", "--output"; the long one last
    std::string type;                ///< "MM", "x|y|z", "OUT.png"; empty: a switch without a value
    std::string fallback;            ///< the value without it; empty: not given
    std::string help;
    bool is_required = false;
    bool is_repeated = false;
};

struct ArgumentRow {
    std::string name;  ///< "MODEL|JOB"
    std::string type;  ///< its words, "on|off"; else empty
    std::string help;
    bool is_required = false;
    bool is_repeated = false;
};

struct ExitCodeRow {
    std::string code;
    std::string meaning;
};

/// A program, a group of commands or a command, as --help describes it.
struct CommandTable {
    std::string name;                   ///< the last word of what is typed: "save"
    std::string summary;                ///< one line
    std::vector<std::string> details;   ///< paragraphs
    std::vector<std::string> examples;  ///< lines that can be typed
    std::vector<ExitCodeRow> exit_codes;
    std::vector<ArgumentRow> arguments;
    std::vector<OptionRow> options;
    std::vector<CommandTable> commands;
};

/// A command with the words before its name.
struct PlacedCommand {
    std::vector<std::string> words;  ///< "psicarve", "snapshot", "save"; for the program itself one word
    const CommandTable* table;
};
/// The program itself first, then all below it. The table outlives what is returned.
std::vector<PlacedCommand> all_commands(const CommandTable& program);

/// The words from `first` on, with `between` between them.
std::string joined(const std::vector<std::string>& words, const std::string& between, std::size_t first = 0);

/// "slice:--up": an option, or where an argument stands, of a command.
std::string labelled(const std::string& command, const std::string& what);

/// Takes the part of a help page after its options: paragraphs, "Example:" with one line each, and "Exit
/// codes: 0 done; 2 wrong usage; ...".
void take_footer(const std::string& footer, CommandTable& table);

}  // namespace psicarve::manual

// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/manual/command_table.hpp"

#include <cstddef>
#include <sstream>
#include <string_view>

namespace psicarve::manual {
namespace {

constexpr std::string_view kExampleHead = "Example:";
constexpr std::string_view kExitCodeHead = "Exit codes:";

bool begins_with(const std::string& text, std::string_view head) {
    return text.compare(0, head.size(), head) == 0;
}

std::string without_blanks_around(const std::string& text) {
    const std::size_t first = text.find_first_not_of(" \n");
    if (first == std::string::npos) return {};
    return text.substr(first, text.find_last_not_of(" \n") - first + 1);
}

void take_exit_codes(const std::string& text, std::vector<ExitCodeRow>& rows) {
    std::istringstream parts{text};
    for (std::string part; std::getline(parts, part, ';');) {
        std::string row = without_blanks_around(part);
        if (!row.empty() && row.back() == '.') row.pop_back();
        const std::size_t blank = row.find(' ');
        if (blank != std::string::npos) rows.push_back({row.substr(0, blank), row.substr(blank + 1)});
    }
}

void place(const CommandTable& table, std::vector<std::string> words, std::vector<PlacedCommand>& commands) {
    words.push_back(table.name);
    commands.push_back({words, &table});
    for (const CommandTable& below : table.commands) place(below, words, commands);
}

}  // namespace

std::vector<PlacedCommand> all_commands(const CommandTable& program) {
    std::vector<PlacedCommand> commands;
    place(program, {}, commands);
    return commands;
}

std::string joined(const std::vector<std::string>& words, const std::string& between, std::size_t first) {
    std::string text;
    for (std::size_t i = first; i < words.size(); ++i) text += (i == first ? "" : between) + words[i];
    return text;
}

std::string labelled(const std::string& command, const std::string& what) {
    std::string label = command;
    label += ':';
    label += what;
    return label;
}

void take_footer(const std::string& footer, CommandTable& table) {
    std::istringstream lines{footer};
    std::string paragraph;
    std::string codes;
    enum class Part { details, examples, exit_codes } part = Part::details;
    const auto end_paragraph = [&] {
        if (!paragraph.empty()) table.details.push_back(paragraph);
        paragraph.clear();
    };
    for (std::string line; std::getline(lines, line);) {
        std::string text = without_blanks_around(line);
        if (begins_with(text, kExampleHead)) {
            part = Part::examples;
            continue;
        }
        if (begins_with(text, kExitCodeHead)) {
            part = Part::exit_codes;
            text.erase(0, kExitCodeHead.size());
        }
        if (part == Part::examples && !text.empty()) table.examples.push_back(text);
        if (part == Part::exit_codes) codes += text + " ";
        if (part != Part::details) continue;
        if (text.empty()) end_paragraph();
        if (!text.empty()) paragraph += (paragraph.empty() ? "" : " ") + text;
    }
    end_paragraph();
    take_exit_codes(codes, table.exit_codes);
}

}  // namespace psicarve::manual

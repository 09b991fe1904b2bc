// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/manual/man_page.hpp"

#include <cctype>
#include <cstddef>
#include <sstream>

#include "hmi/manual/value_completion.hpp"

namespace psicarve::manual {
namespace {

std::string in_capitals(std::string text) {
    for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    return text;
}

std::string bold(const std::string& text) {
    return "\\fB" + man_text(text) + "\\fR";
}
std::string italic(const std::string& text) {
    return "\\fI" + man_text(text) + "\\fR";
}

/// "[OPTION]... MODEL|JOB"
std::string synopsis(const PlacedCommand& placed) {
    const CommandTable& table = *placed.table;
    std::string text = bold(joined(placed.words, " ")) + " [" + italic("OPTION") + "]...";
    for (const OptionRow& option : table.options)
        if (option.is_required) text += " " + bold(option.names.front()) + " " + italic(option.type);
    for (const ArgumentRow& argument : table.arguments) {
        const std::string more = argument.is_repeated ? "..." : "";
        const std::string name = italic(argument.name) + more;
        text += argument.is_required ? " " + name : " [" + name + "]";
    }
    if (!table.commands.empty()) text += " " + italic("COMMAND");
    return text;
}

std::string sentence(const std::string& text) {
    const char last = text.empty() ? '.' : text.back();
    return man_paragraph(man_text(text) + (last == '.' || last == '?' ? "" : "."));
}

std::string entry(const std::string& term, const std::string& text) {
    return ".TP\n" + term + "\n" + text + "\n";
}

std::string option_entry(const OptionRow& option) {
    std::string term;
    for (const std::string& name : option.names) {
        term += (term.empty() ? "" : ", ") + bold(name);
        if (takes_value(option)) term += (name[1] == '-' ? "=" : " ") + italic(option.type);
    }
    std::string text = sentence(option.help);
    if (!option.fallback.empty()) text += "\nWithout it: " + bold(option.fallback) + ".";
    if (option.is_required) text += "\nMust be given.";
    if (option.is_repeated) text += "\nMay be given more than once.";
    return entry(term, text);
}

std::string argument_entry(const ArgumentRow& argument) {
    std::string text = sentence(argument.help);
    if (!argument.type.empty()) text += "\nOne of " + bold(argument.type) + ".";
    return entry(italic(argument.name), text);
}

}  // namespace

std::string man_text(const std::string& text) {
    std::string result;
    for (const char c : text) {
        if (c == '\\') {
            result += "\\e";
        } else if (c == '-') {
            result += "\\-";
        } else if (c == '\'') {
            result += "\\(aq";
        } else if (c == '^') {
            result += "\\(ha";
        } else if (c == '~') {
            result += "\\(ti";
        } else if (c == '.' && (result.empty() || result.back() == '\n' || result.back() == ' ')) {
            result += "\\&.";
        } else {
            result += c;
        }
    }
    return result;
}

std::string man_paragraph(const std::string& text) {
    constexpr std::size_t kMostColumns = 80;
    std::istringstream words{text};
    std::string result;
    std::size_t columns = 0;
    for (std::string word; words >> word;) {
        const bool is_full = columns > 0 && columns + 1 + word.size() > kMostColumns;
        if (columns > 0) result += is_full ? '\n' : ' ';
        columns = is_full || columns == 0 ? word.size() : columns + 1 + word.size();
        result += word;
    }
    return result;
}

std::string page_name(const std::vector<std::string>& words) {
    return joined(words, "-");
}

std::string man_head(const std::string& name, const std::string& section, const std::string& summary,
                     const Edition& edition) {
    return ".\\\" Made from the program's own table.\n.\\\" SPDX-License-Identifier: GPL-3.0-or-later\n.TH " +
           man_text(in_capitals(name)) + " " + section + " " + edition.date + " \"psicarve " +
           edition.version + "\" Psicarve\n.SH NAME\n" +
           man_paragraph(man_text(name) + " \\- " + man_text(summary)) + "\n";
}

std::string man_also(const std::vector<std::string>& also) {
    std::string text = ".SH SEE ALSO\n";
    for (std::size_t i = 0; i < also.size(); ++i) {
        const std::size_t bracket = also[i].rfind('(');
        text += ".BR " + man_text(also[i].substr(0, bracket)) + " " + also[i].substr(bracket) +
                (i + 1 < also.size() ? " ,\n" : "\n");
    }
    return text;
}

std::string man_page(const PlacedCommand& command, const std::vector<std::string>& also,
                     const Edition& edition) {
    const CommandTable& table = *command.table;
    std::string text = man_head(page_name(command.words), "1", table.summary, edition) + ".SH SYNOPSIS\n" +
                       man_paragraph(synopsis(command)) + "\n.SH DESCRIPTION\n" + sentence(table.summary) +
                       "\n";
    for (const std::string& paragraph : table.details) text += ".PP\n" + sentence(paragraph) + "\n";
    if (!table.commands.empty()) text += ".SH COMMANDS\n";
    for (const CommandTable& below : table.commands) text += entry(bold(below.name), sentence(below.summary));
    if (!table.arguments.empty()) text += ".SH ARGUMENTS\n";
    for (const ArgumentRow& argument : table.arguments) text += argument_entry(argument);
    if (!table.options.empty()) text += ".SH OPTIONS\n";
    for (const OptionRow& option : table.options) text += option_entry(option);
    if (!table.exit_codes.empty()) text += ".SH EXIT STATUS\n";
    for (const ExitCodeRow& row : table.exit_codes) text += entry(bold(row.code), sentence(row.meaning));
    if (!table.examples.empty()) text += ".SH EXAMPLES\n.nf\n";
    for (const std::string& example : table.examples) text += man_text(example) + "\n";
    if (!table.examples.empty()) text += ".fi\n";
    return text + man_also(also);
}

}  // namespace psicarve::manual

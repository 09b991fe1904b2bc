// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/manual/window_table.hpp"

#include <algorithm>
#include <cstddef>

namespace psicarve::manual {
namespace {

CommandTable make_window_table() {
    CommandTable table;
    table.name = "psicarve-hmi";
    table.summary = "The operator's window of the two-head engraver";
    table.details = {
        "Shows the machine whose core serves the segment, opens models and jobs, slices, publishes, starts,\n"
        "holds and stops. A saved snapshot or a binary trace is shown as a replay."};
    table.examples = {"psicarve-rtcore --port sim --clock real & psicarve-hmi examples/figurine.stl"};
    table.exit_codes = {
        {"0", "done"}, {"2", "wrong usage"}, {"3", "what was being saved or printed could not be written"}};
    table.arguments = {
        {"MODEL|JOB|TRACE", "", "A model, job, snapshot or binary trace to open", false, false}};
    const auto option = [&](std::vector<std::string> names, const char* type, const char* help) {
        table.options.push_back({std::move(names), type, "", help, false, false});
    };
    option({"--segment"}, "NAME", "The core's shared-memory segment (default /psicarve)");
    option({"--profile"}, "FILE", "The machine's profile, as the core has it (default: the built-in one)");
    option({"--group"}, "NAME", "The segment belongs to this group");
    option({"--state"}, "FOLDER", "Where the core keeps what is unfinished, if it was given --state");
    option({"--language"}, "en|zh_CN|ru", "For this time (default: chosen in the menu, or the desktop's)");
    option({"--opengl"}, "", "Draw the views of the space with OpenGL even where no graphics card does it");
    option({"--no-opengl"}, "", "Draw them without");
    option({"-h", "--help"}, "", "Print this");
    option({"--version"}, "", "Print the version");
    return table;
}

/// "-h,--help", "--segment NAME"
std::string term_of(const OptionRow& option) {
    return joined(option.names, ",") + (option.type.empty() ? "" : " " + option.type);
}

}  // namespace

const CommandTable& window_table() {
    static const CommandTable table = make_window_table();
    return table;
}

const OptionRow* window_option(const std::string& name) {
    for (const OptionRow& option : window_table().options) {
        if (std::find(option.names.begin(), option.names.end(), name) != option.names.end()) return &option;
    }
    return nullptr;
}

std::string window_help() {
    const CommandTable& table = window_table();
    std::string text = "usage: " + table.name + " [OPTIONS] [" + table.arguments.front().name + "]\n\n" +
                       table.summary + ".\n";
    for (const std::string& paragraph : table.details) text += paragraph + "\n";
    text += "\n";
    std::size_t width = 0;
    for (const OptionRow& option : table.options) width = std::max(width, term_of(option).size());
    for (const OptionRow& option : table.options) {
        const std::string term = term_of(option);
        text += "  " + term + std::string(width + 2 - term.size(), ' ') + option.help + "\n";
    }
    text += "\nExample:\n";
    for (const std::string& example : table.examples) text += "  " + example + "\n";
    text += "\nExit codes:";
    for (const ExitCodeRow& row : table.exit_codes)
        text += " " + row.code + " " + row.meaning + (&row == &table.exit_codes.back() ? ".\n" : ";");
    return text;
}

}  // namespace psicarve::manual

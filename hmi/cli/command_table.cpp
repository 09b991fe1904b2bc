// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/command_table.hpp"

#include <CLI/CLI.hpp>

namespace psicarve::cli {
namespace {

manual::ArgumentRow argument_row(const CLI::Option& option) {
    return {option.get_name(true), option.get_type_name(), option.get_description(), option.get_required(),
            option.get_items_expected_max() > 1};
}

manual::OptionRow option_row(const CLI::Option& option) {
    manual::OptionRow row;
    for (const std::string& name : option.get_snames()) row.names.push_back("-" + name);
    for (const std::string& name : option.get_lnames()) row.names.push_back("--" + name);
    const bool has_value = option.get_items_expected_max() > 0;
    if (has_value) row.type = option.get_type_name();
    if (has_value && row.type.empty()) row.type = "VALUE";
    row.fallback = option.get_default_str();
    row.help = option.get_description();
    row.is_required = option.get_required();
    row.is_repeated = option.get_items_expected_max() > 1 && option.get_allow_extra_args();
    return row;
}

}  // namespace

manual::CommandTable table_of(const CLI::App& app) {
    manual::CommandTable table;
    table.name = app.get_name();
    table.summary = app.get_description();
    if (!table.summary.empty() && table.summary.back() == '.') table.summary.pop_back();
    manual::take_footer(app.get_footer(), table);
    for (const CLI::Option* option : app.get_options()) {
        if (option->get_positional()) table.arguments.push_back(argument_row(*option));
        if (option->nonpositional()) table.options.push_back(option_row(*option));
    }
    for (const CLI::App* below : app.get_subcommands({})) table.commands.push_back(table_of(*below));
    return table;
}

}  // namespace psicarve::cli

// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/program.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <cstring>
#include <sstream>

#include "hmi/cli/command_set.hpp"
#include "hmi/cli/commands.hpp"
#include "hmi/cli/escaped_output.hpp"
#include "hmi/cli/exit_code.hpp"
#include "hmi/cli/job_source.hpp"
#include "hmi/cli/named_files.hpp"
#include "shared/base/nearest.hpp"
#include "shared/file/distinct_files.hpp"
#include "shared/file/partial_file.hpp"

namespace psicarve::cli {
namespace {

constexpr const char* kExitCodes =
    "Exit codes: 0 done; 2 wrong usage; 3 bad input, nothing was changed; 4 the machine refused or raised "
    "an\n"
    "alarm; 5 no core or no segment; 6 verification found a difference.";

void add_all_commands(CommandSet& commands) {
    add_carve(commands);
    add_slice(commands);
    add_inspect(commands);
    add_estimate(commands);
    add_publish(commands);
    add_status(commands);
    add_log(commands);
    add_home(commands);
    add_start(commands);
    add_start_interpolation(commands);
    add_hold(commands);
    add_resume(commands);
    add_override(commands);
    add_stop(commands);
    add_estop(commands);
    add_reset_alarm(commands);
    add_back_off(commands);
    add_reset_height(commands);
    add_jog(commands);
    add_move(commands);
    add_single(commands);
    add_optional_stop(commands);
    add_spindle(commands);
    add_drives_off(commands);
    add_forget(commands);
    add_pins(commands);
    CommandSet snapshot = commands.group("snapshot", "Save, look at, export and compare snapshots and jobs");
    add_snapshot_save(snapshot);
    add_snapshot_info(snapshot);
    add_snapshot_export(snapshot);
    add_snapshot_diff(snapshot);
    CommandSet gcode = commands.group("gcode", "Check and run programs in G-code");
    add_gcode_check(gcode);
    add_gcode_run(gcode);
    add_gcode_estimate(gcode);
    add_gcode_offsets(gcode);
    add_replay(commands);
    add_verify(commands);
    add_calibrate(commands);
    add_doctor(commands);
    add_latency(commands);
    CommandSet profile = commands.group("profile", "Check, show, compare and change machine profiles");
    add_profile_check(profile);
    add_profile_show(profile);
    add_profile_path(profile);
    add_profile_diff(profile);
    add_profile_set(profile);
    add_completion(commands);
}

/// The parser with all commands. Not movable: commands refer to its members.
struct Grammar {
    Grammar() {
        program.require_subcommand(1);
        program.set_version_flag("--version", PSICARVE_VERSION);
        program.footer(std::string{"psicarve COMMAND --help explains each with an example.\n"} + kExitCodes);
        commands.add_common_options();
        add_all_commands(commands);
    }
    Grammar(const Grammar&) = delete;
    Grammar& operator=(const Grammar&) = delete;

    CLI::App program{"Slices models, publishes jobs and runs the two-head engraver.", "psicarve"};
    CommonOptions common;
    CommandBody chosen;
    CommandSet commands{program, common, chosen};
};

/// The innermost command that was typed.
CLI::App& typed_command(CLI::App& program) {
    CLI::App* app = &program;
    while (!app->get_subcommands().empty()) app = app->get_subcommands().front();
    return *app;
}

std::string full_name(const CLI::App& app) {
    const CLI::App* parent = app.get_parent();
    return parent == nullptr ? app.get_name() : full_name(*parent) + " " + app.get_name();
}

std::vector<std::string> option_names(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::Option* option : app.get_options()) {
        for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
        for (const std::string& name : option->get_snames()) names.push_back("-" + name);
    }
    return names;
}

std::vector<std::string> command_names(CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
    return names;
}

/// The error for a word that no command or option knows.
std::string unknown_word(CLI::App& app, const std::string& word) {
    const bool is_option = word.size() > 1 && word.front() == '-';
    const bool wants_command = !app.get_subcommands({}).empty();
    std::string text = is_option       ? "unknown option "
                       : wants_command ? "unknown command "
                                       : "unexpected argument ";
    const std::string name = word.substr(0, word.find('='));
    text += "'" + (is_option ? name : word) + "'";
    std::optional<std::string> meant;
    if (is_option) {
        meant = nearest(name, option_names(app));
    } else if (wants_command) {
        meant = nearest(word, command_names(app));
    }
    if (meant) text += "; did you mean '" + *meant + "'?";
    return text;
}

std::string usage_error(CLI::App& program, const CLI::ParseError& error) {
    CLI::App& app = typed_command(program);
    const std::vector<std::string> unknown = program.remaining(true);
    const auto is_option = [](const std::string& word) { return word.size() > 1 && word.front() == '-'; };
    // A mistyped option explains more than the words that are missing or left over because of it.
    auto culprit = std::find_if(unknown.begin(), unknown.end(), is_option);
    if (culprit == unknown.end()) culprit = unknown.begin();
    const std::string text = culprit == unknown.end() ? error.what() : unknown_word(app, *culprit);
    return text + " (see: " + full_name(app) + " --help)";
}

bool asks_for_json(int argc, char** argv) {
    return std::any_of(argv, argv + argc, [](const char* word) { return std::strcmp(word, "--json") == 0; });
}

int finish(const Result<int>& outcome, bool as_json) {
    if (!outcome) return report_error(outcome.error(), as_json);
    if (const auto flushed = flush_output(); !flushed) return report_error(flushed.error(), false);
    return *outcome;
}

/// Help, or the version.
int print_what_was_asked(const CLI::App& program, const CLI::Success& success) {
    std::ostringstream text;
    program.exit(success, text, text);
    std::fputs(text.str().c_str(), stdout);
    return finish(kExitDone, false);
}

/// A named profile that is wrong is never ignored, not even where a command does not use it. But a stop must
/// work without it, and the command that mends it reads it in its own way.
Result<void> check_named_profile(const CLI::App& command, const CommonOptions& common) {
    const std::string name = full_name(command);
    if (common.profile.empty() || name == "psicarve profile set") return {};
    const auto profile = chosen_profile(common);
    if (profile) return {};
    const bool stops = name == "psicarve estop" || name == "psicarve stop" || name == "psicarve hold";
    if (!stops) return profile.error();
    print_warning(profile.error().message + "; going on without a profile");
    return {};
}

}  // namespace

int run(int argc, char** argv) {
    remove_partials_when_killed();
    const EscapedOutput escaped_output;
    Grammar grammar;
    CLI::App& program = grammar.program;
    const CommonOptions& common = grammar.common;
    try {
        program.parse(argc, argv);
    } catch (const CLI::Success& success) {
        return print_what_was_asked(program, success);
    } catch (const CLI::ParseError& error) {
        return report_error(Error{ErrorCode::bad_usage, usage_error(program, error)},
                            asks_for_json(argc, argv));
    }
    const auto files = named_files(typed_command(program));
    if (const auto named = check_no_stream(files); !named) return report_error(named.error(), common.json);
    if (const auto distinct = check_distinct(files); !distinct)
        return report_error(distinct.error(), common.json);
    if (const auto good = check_named_profile(typed_command(program), common); !good)
        return report_error(good.error(), common.json);
    return finish(grammar.chosen(common), common.json);
}

manual::CommandTable program_table() {
    return Grammar{}.commands.table();
}

}  // namespace psicarve::cli

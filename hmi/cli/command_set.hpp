// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "hmi/manual/command_table.hpp"
#include "shared/base/result.hpp"
#include "shared/segment/layout.hpp"
#include "shared/segment/segment.hpp"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace psicarve::cli {

/// The options of every command.
struct CommonOptions {
    std::string segment = kDefaultSegmentName;
    std::string group;
    std::string profile;  ///< TOML, or a job file for the profile in it; empty: none given
    bool json = false;
};

/// A command's work: its exit code, or the error that the program reports.
using CommandBody = std::function<Result<int>(const CommonOptions&)>;

struct CommandText {
    const char* name;
    const char* summary;  ///< one line
    const char* details;  ///< further text of --help; may be empty
    const char* example;  ///< one or more lines that can be typed
};

/// Where a command keeps the names of the files that it reads: each may be "-".
struct InputTargets {
    std::vector<std::string*> files;
    std::vector<std::vector<std::string>*> lists;
};

/// Whether the option was added with `Syntax::input` or `inputs`.
bool reads_standard_input(const CLI::Option& option);

/// The arguments and options of one command: a thin cover over the parser, so that a command's file does not
/// need it. Targets outlive the parsing and keep their values where the option is not given. An empty text is
/// wrong usage.
class Syntax {
public:
    Syntax(CLI::App& app, std::shared_ptr<InputTargets> inputs) noexcept
        : app_(&app), inputs_(std::move(inputs)) {}

    Syntax& argument(const char* name, std::string& target, const char* help);
    /// A file to read. "-": standard input, read whole before the command's body begins, which gets the name
    /// of a file that can be read; not read for --help, nor after any other wrong usage.
    Syntax& input(const char* name, std::string& target, const char* help);
    Syntax& optional_input(const char* name, std::string& target, const char* help);
    /// A file that is read as it comes: "-" stays "-", and the body reads standard input itself.
    Syntax& stream(const char* name, std::string& target, const char* help);
    /// One or more of them.
    Syntax& inputs(const char* name, std::vector<std::string>& target, const char* help);
    /// May be left out.
    Syntax& words(const char* names, std::vector<std::string>& target, const char* type, const char* help);
    /// A whole number within the bounds.
    Syntax& argument(const char* name, std::uint32_t& target, std::uint32_t least, std::uint32_t most,
                     const char* help);
    Syntax& optional_argument(const char* name, std::string& target, const char* help);
    /// Any number of words.
    Syntax& optional_arguments(const char* name, std::vector<std::string>& target, const char* help);
    /// One or more words.
    Syntax& arguments(const char* name, std::vector<std::string>& target, const char* help);
    Syntax& option(const char* names, std::string& target, const char* type, const char* help);
    Syntax& required_option(const char* names, std::string& target, const char* type, const char* help);
    /// A whole number within the bounds.
    Syntax& option(const char* names, std::uint32_t& target, std::uint32_t least, std::uint32_t most,
                   const char* help);
    /// A number greater than zero.
    Syntax& option(const char* names, std::optional<double>& target, const char* type, const char* help);
    /// A number that may be zero.
    Syntax& option_from_zero(const char* names, std::optional<double>& target, const char* type,
                             const char* help);
    /// --picture, whose file is a PNG.
    Syntax& picture_option(std::string& target);
    Syntax& choice(const char* names, std::string& target, const std::vector<std::string>& words,
                   const char* help);
    Syntax& choice_argument(const char* name, std::string& target, const std::vector<std::string>& words,
                            const char* help);
    Syntax& flag(const char* names, bool& target, const char* help);
    Syntax& excludes(const char* one, const char* other);

private:
    CLI::App* app_;
    std::shared_ptr<InputTargets> inputs_;
};

/// All commands of the program, or those of a group ("snapshot ...").
class CommandSet {
public:
    CommandSet(CLI::App& app, CommonOptions& common, CommandBody& chosen) noexcept
        : app_(&app), common_(&common), chosen_(&chosen) {}

    /// After parsing, the program runs the body of the command that was typed.
    Syntax add(const CommandText& text, CommandBody body);
    /// For commands whose output is not a report: without --json.
    Syntax add_plain(const CommandText& text, CommandBody body);
    CommandSet group(const char* name, const char* summary);
    /// The commands as --help describes them; the program's table, if these are all its commands.
    manual::CommandTable table() const;
    /// The common options may also stand before the command's name.
    void add_common_options();

private:
    Syntax add_to(const CommandText& text, CommandBody body, bool has_json);

    CLI::App* app_;
    CommonOptions* common_;
    CommandBody* chosen_;
};

}  // namespace psicarve::cli

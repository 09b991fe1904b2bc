// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/command_set.hpp"

#include <CLI/CLI.hpp>
#include <cctype>
#include <charconv>
#include <cmath>
#include <string>
#include <system_error>
#include <utility>

#include "hmi/cli/command_table.hpp"
#include "hmi/cli/standard_streams.hpp"

namespace psicarve::cli {
namespace {

std::string check_not_empty(const std::string& text) {
    return text.empty() ? "the name is empty" : std::string{};
}

std::string check_segment_name(const std::string& name) {
    const bool is_plain = name.size() >= 2 && name.size() <= 200 && name.front() == '/' &&
                          name.find('/', 1) == std::string::npos;
    return is_plain ? std::string{} : "a segment's name begins with / and has no other, as in /psicarve";
}

void add_common(CLI::App& app, CommonOptions& common, bool has_json) {
    app.add_option("--segment", common.segment, "Shared-memory segment of the machine")
        ->type_name("NAME")
        ->capture_default_str()
        ->check(check_segment_name);
    app.add_option("--profile", common.profile,
                   "Machine profile; without it the job's own, else the one that 'profile path' tells")
        ->type_name("FILE")
        ->check(check_not_empty);
    app.add_option("--group", common.group, "The segment belongs to this group's service user")
        ->type_name("NAME")
        ->check(check_not_empty);
    if (has_json) app.add_flag("--json", common.json, "Report as one JSON object on standard output");
}

std::string check_png_name(const std::string& name) {
    const std::size_t dot = name.rfind('.');
    std::string ending = dot == std::string::npos ? "" : name.substr(dot);
    for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return ending == ".png" ? std::string{}
                            : "'" + name + "': a picture is a PNG file, its name ends in .png";
}

bool is_number(const std::string& text, double& value) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc{} && end == text.data() + text.size() && std::isfinite(value);
}

std::string check_more_than_zero(const std::string& text) {
    double value = 0.0;
    const bool is_good = is_number(text, value) && value > 0.0;
    return is_good ? std::string{} : "'" + text + "' is not a number greater than 0";
}

std::string check_at_least_zero(const std::string& text) {
    double value = 0.0;
    const bool is_good = is_number(text, value) && value >= 0.0;
    return is_good ? std::string{} : "'" + text + "' is not a number from 0 on";
}

/// The end of an input's help.
constexpr const char* kReadsStandardInput = "; - reads standard input";

/// Standard input as a file.
Result<void> read_if_standard(std::string& name) {
    if (name != "-") return {};
    auto path = file_of_standard_input();
    if (!path) return path.error();
    name = std::move(path).value();
    return {};
}

Result<void> read_standard_input(const InputTargets& inputs) {
    for (std::string* file : inputs.files)
        if (auto read = read_if_standard(*file); !read) return read;
    for (std::vector<std::string>* list : inputs.lists)
        for (std::string& file : *list)
            if (auto read = read_if_standard(file); !read) return read;
    return {};
}

/// "x|y|z"
std::string one_of(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : "|") + word;
    return text;
}

}  // namespace

bool reads_standard_input(const CLI::Option& option) {
    return option.get_description().ends_with(kReadsStandardInput);
}

Syntax& Syntax::argument(const char* name, std::string& target, const char* help) {
    app_->add_option(name, target, help)->required()->type_name("")->check(check_not_empty);
    return *this;
}

Syntax& Syntax::input(const char* name, std::string& target, const char* help) {
    app_->add_option(name, target, std::string{help} + kReadsStandardInput)
        ->required()
        ->type_name("")
        ->check(check_not_empty);
    inputs_->files.push_back(&target);
    return *this;
}

Syntax& Syntax::stream(const char* name, std::string& target, const char* help) {
    app_->add_option(name, target, std::string{help} + kReadsStandardInput)
        ->required()
        ->type_name("")
        ->check(check_not_empty);
    return *this;
}

Syntax& Syntax::optional_input(const char* name, std::string& target, const char* help) {
    app_->add_option(name, target, std::string{help} + kReadsStandardInput)
        ->type_name("")
        ->check(check_not_empty);
    inputs_->files.push_back(&target);
    return *this;
}

Syntax& Syntax::inputs(const char* name, std::vector<std::string>& target, const char* help) {
    app_->add_option(name, target, std::string{help} + kReadsStandardInput)
        ->required()
        ->type_name("")
        ->check(check_not_empty);
    inputs_->lists.push_back(&target);
    return *this;
}

Syntax& Syntax::argument(const char* name, std::uint32_t& target, std::uint32_t least, std::uint32_t most,
                         const char* help) {
    app_->add_option(name, target, help)
        ->required()
        ->type_name("")
        ->check(CLI::Range(least, most).description(""));
    return *this;
}

Syntax& Syntax::optional_argument(const char* name, std::string& target, const char* help) {
    app_->add_option(name, target, help)->type_name("")->check(check_not_empty);
    return *this;
}

Syntax& Syntax::optional_arguments(const char* name, std::vector<std::string>& target, const char* help) {
    app_->add_option(name, target, help)->type_name("")->expected(0, -1);
    return *this;
}

Syntax& Syntax::arguments(const char* name, std::vector<std::string>& target, const char* help) {
    app_->add_option(name, target, help)->required()->type_name("")->expected(-1);
    return *this;
}

Syntax& Syntax::option(const char* names, std::string& target, const char* type, const char* help) {
    app_->add_option(names, target, help)->type_name(type)->check(check_not_empty);
    return *this;
}

Syntax& Syntax::words(const char* names, std::vector<std::string>& target, const char* type,
                      const char* help) {
    app_->add_option(names, target, help)->type_name(type)->delimiter(',')->allow_extra_args(false);
    return *this;
}

Syntax& Syntax::required_option(const char* names, std::string& target, const char* type, const char* help) {
    app_->add_option(names, target, help)->type_name(type)->required()->check(check_not_empty);
    return *this;
}

Syntax& Syntax::option(const char* names, std::uint32_t& target, std::uint32_t least, std::uint32_t most,
                       const char* help) {
    app_->add_option(names, target, help)->type_name("N")->check(CLI::Range(least, most).description(""));
    return *this;
}

Syntax& Syntax::option(const char* names, std::optional<double>& target, const char* type, const char* help) {
    app_->add_option(names, target, help)->type_name(type)->check(check_more_than_zero);
    return *this;
}

Syntax& Syntax::option_from_zero(const char* names, std::optional<double>& target, const char* type,
                                 const char* help) {
    app_->add_option(names, target, help)->type_name(type)->check(check_at_least_zero);
    return *this;
}

Syntax& Syntax::picture_option(std::string& target) {
    app_->add_option("--picture", target, "Draw the piece as it comes out of the pins")
        ->type_name("OUT.png")
        ->check(check_png_name);
    return *this;
}

Syntax& Syntax::choice(const char* names, std::string& target, const std::vector<std::string>& words,
                       const char* help) {
    app_->add_option(names, target, help)
        ->type_name(one_of(words))
        ->check(CLI::IsMember(words).description(""));
    return *this;
}

Syntax& Syntax::choice_argument(const char* name, std::string& target, const std::vector<std::string>& words,
                                const char* help) {
    app_->add_option(name, target, help)
        ->required()
        ->type_name(one_of(words))
        ->check(CLI::IsMember(words).description(""));
    return *this;
}

Syntax& Syntax::flag(const char* names, bool& target, const char* help) {
    app_->add_flag(names, target, help);
    return *this;
}

Syntax& Syntax::excludes(const char* one, const char* other) {
    app_->get_option(one)->excludes(app_->get_option(other));
    return *this;
}

Syntax CommandSet::add(const CommandText& text, CommandBody body) {
    return add_to(text, std::move(body), true);
}

Syntax CommandSet::add_plain(const CommandText& text, CommandBody body) {
    return add_to(text, std::move(body), false);
}

Syntax CommandSet::add_to(const CommandText& text, CommandBody body, bool has_json) {
    CLI::App* app = app_->add_subcommand(text.name, text.summary);
    std::string footer = text.details;
    if (!footer.empty()) footer += "\n\n";
    app->footer(footer + "Example:\n  " + text.example);
    const auto inputs = std::make_shared<InputTargets>();
    app->callback([chosen = chosen_, inputs, work = std::move(body)] {
        *chosen = [inputs, work](const CommonOptions& common) -> Result<int> {
            if (const auto read = read_standard_input(*inputs); !read) return read.error();
            return work(common);
        };
    });
    add_common(*app, *common_, has_json);
    return Syntax{*app, inputs};
}

void CommandSet::add_common_options() {
    add_common(*app_, *common_, true);
}

manual::CommandTable CommandSet::table() const {
    return table_of(*app_);
}

CommandSet CommandSet::group(const char* name, const char* summary) {
    CLI::App* app = app_->add_subcommand(name, summary);
    app->require_subcommand(1);
    return CommandSet{*app, *common_, *chosen_};
}

}  // namespace psicarve::cli

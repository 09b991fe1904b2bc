// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/command_set.hpp"

#include <CLI/CLI.hpp>
#include <utility>

namespace psicarve::cli {
namespace {

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
                   "Machine profile; without it the built-in 'default', or the job's own")
        ->type_name("FILE");
    app.add_option("--group", common.group, "The segment belongs to this group's service user")
        ->type_name("NAME");
    if (has_json) app.add_flag("--json", common.json, "Report as one JSON object on standard output");
}

/// "x|y|z"
std::string one_of(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : "|") + word;
    return text;
}

}  // namespace

Syntax& Syntax::argument(const char* name, std::string& target, const char* help) {
    app_->add_option(name, target, help)->required()->type_name("");
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
    app_->add_option(name, target, help)->type_name("");
    return *this;
}

Syntax& Syntax::arguments(const char* name, std::vector<std::string>& target, const char* help) {
    app_->add_option(name, target, help)->required()->type_name("")->expected(-1);
    return *this;
}

Syntax& Syntax::option(const char* names, std::string& target, const char* type, const char* help) {
    app_->add_option(names, target, help)->type_name(type);
    return *this;
}

Syntax& Syntax::words(const char* names, std::vector<std::string>& target, const char* type,
                      const char* help) {
    app_->add_option(names, target, help)->type_name(type)->delimiter(',')->allow_extra_args(false);
    return *this;
}

Syntax& Syntax::required_option(const char* names, std::string& target, const char* type, const char* help) {
    app_->add_option(names, target, help)->type_name(type)->required();
    return *this;
}

Syntax& Syntax::option(const char* names, std::uint32_t& target, std::uint32_t least, std::uint32_t most,
                       const char* help) {
    app_->add_option(names, target, help)->type_name("N")->check(CLI::Range(least, most).description(""));
    return *this;
}

Syntax& Syntax::option(const char* names, std::optional<double>& target, const char* type, const char* help) {
    app_->add_option(names, target, help)
        ->type_name(type)
        ->check(CLI::Validator{CLI::PositiveNumber}.description(""));
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
    app->callback([chosen = chosen_, work = std::move(body)] { *chosen = work; });
    add_common(*app, *common_, has_json);
    return Syntax{*app};
}

void CommandSet::add_common_options() {
    add_common(*app_, *common_, true);
}

CommandSet CommandSet::group(const char* name, const char* summary) {
    CLI::App* app = app_->add_subcommand(name, summary);
    app->require_subcommand(1);
    return CommandSet{*app, *common_, *chosen_};
}

}  // namespace psicarve::cli

// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdio>
#include <memory>
#include <string>

#include "hmi/cli/command_set.hpp"
#include "hmi/cli/commands.hpp"
#include "hmi/cli/exit_code.hpp"
#include "hmi/manual/shell_completion.hpp"

namespace psicarve::cli {
namespace {

constexpr CommandText kCompletionText{
    "completion", "What a shell reads to complete psicarve's command line",
    "A script on standard output: commands, options, their values and files of the kinds that they take.\n"
    "An installed psicarve has it where the shells look for it.",
    "psicarve completion bash > ~/.local/share/bash-completion/completions/psicarve\n"
    "  psicarve completion fish > ~/.config/fish/completions/psicarve.fish"};

std::string script_for(const std::string& shell, const manual::CommandTable& program) {
    if (shell == "bash") return manual::bash_completion(program);
    return shell == "zsh" ? manual::zsh_completion(program) : manual::fish_completion(program);
}

}  // namespace

void add_completion(CommandSet& commands) {
    const auto shell = std::make_shared<std::string>();
    // All commands are known when it runs.
    commands
        .add_plain(kCompletionText,
                   [shell, commands](const CommonOptions&) -> Result<int> {
                       std::fputs(script_for(*shell, commands.table()).c_str(), stdout);
                       return kExitDone;
                   })
        .choice_argument("SHELL", *shell, {"bash", "zsh", "fish"}, "The shell");
}

}  // namespace psicarve::cli

// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/carve_queue.hpp"

#include <unistd.h>

#include <cstddef>
#include <cstdio>
#include <iostream>

#include "hmi/cli/exit_code.hpp"
#include "hmi/cli/progress_bar.hpp"

namespace psicarve::cli {
namespace {

std::string names_from(const std::vector<std::string>& paths, std::size_t first) {
    std::string names;
    for (std::size_t i = first; i < paths.size(); ++i) names += (names.empty() ? "" : ", ") + paths[i];
    return names;
}

/// Whether the next blank is in. Nothing but yes is yes.
bool is_next_blank_in(const std::vector<std::string>& paths, std::size_t next) {
    clear_progress_line();
    std::fprintf(
        stderr,
        "psicarve: %zu of %zu carved: %s. The heads stand outside and the spindle is off. Take it out, put "
        "the next blank in.\npsicarve: carve %s now? yes or no: ",
        next, paths.size(), paths[next - 1].c_str(), paths[next].c_str());
    std::string answer;
    return static_cast<bool>(std::getline(std::cin, answer)) && (answer == "yes" || answer == "y");
}

}  // namespace

Result<int> carve_in_turn(const std::vector<std::string>& paths, bool unattended,
                          const std::function<Result<int>(const std::string&)>& carve_one) {
    if (paths.size() > 1 && !unattended && isatty(STDIN_FILENO) == 0)
        return Error{
            ErrorCode::bad_usage,
            "carve: between two workpieces somebody changes the blank and says so at the terminal, and there "
            "is none; --unattended asks nobody"};
    for (std::size_t i = 0; i < paths.size(); ++i) {
        if (i > 0 && !unattended && !is_next_blank_in(paths, i))
            return Error{ErrorCode::cancelled, "not carved, as was answered: " + names_from(paths, i)};
        const auto carved = carve_one(paths[i]);
        if (carved && *carved == kExitDone) continue;
        if (i + 1 < paths.size()) print_note("not carved after this: " + names_from(paths, i + 1));
        return carved;
    }
    return kExitDone;
}

}  // namespace psicarve::cli

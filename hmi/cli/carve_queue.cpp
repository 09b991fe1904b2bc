// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/carve_queue.hpp"

#include <sys/types.h>
#include <termios.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>

#include "hmi/cli/exit_code.hpp"
#include "hmi/cli/operator_break.hpp"

namespace psicarve::cli {
namespace {

std::string names_from(const std::vector<std::string>& paths, std::size_t first) {
    std::string names;
    for (std::size_t i = first; i < paths.size(); ++i) names += (names.empty() ? "" : ", ") + paths[i];
    return names;
}

/// The next line from the terminal; keeps nothing back for later.
std::string typed_line() {
    std::string line;
    for (char letter = 0;;) {
        const ssize_t got = read(STDIN_FILENO, &letter, 1);
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) return {};  // an answer is whole, or none
        if (letter == '\n') return line;
        line += letter;
    }
}

/// Whether the next blank is in. Only yes counts, and nothing that was typed before the question.
bool is_next_blank_in(const std::vector<std::string>& paths, std::size_t next) {
    print_note(std::to_string(next) + " of " + std::to_string(paths.size()) + " carved: " + paths[next - 1] +
               ". The heads stand outside and the spindle is off. Take it out, put the next blank in.");
    (void)tcflush(STDIN_FILENO, TCIFLUSH);
    print_question("carve " + paths[next] + " now? yes or no: ");
    const std::string answer = typed_line();
    return answer == "yes" || answer == "y";
}

}  // namespace

Result<int> carve_in_turn(const std::vector<std::string>& paths, bool unattended,
                          const std::function<Result<int>(const std::string&)>& carve_one) {
    if (paths.size() > 1 && !unattended && isatty(STDIN_FILENO) == 0)
        return Error{
            ErrorCode::bad_usage,
            "carve: between two workpieces somebody changes the blank and says so at the terminal, and there "
            "is none; --unattended asks nobody"};
    const unsigned breaks_before = OperatorBreak::asked_ever();
    for (std::size_t i = 0; i < paths.size(); ++i) {
        if (i > 0 && !unattended && !is_next_blank_in(paths, i))
            return Error{ErrorCode::cancelled, "not carved, as was answered: " + names_from(paths, i)};
        const auto carved = carve_one(paths[i]);
        const bool is_last = i + 1 == paths.size();
        // A break that came too late for a workpiece counts for those behind it.
        const bool was_broken = OperatorBreak::asked_ever() != breaks_before;
        const bool is_done = carved && *carved == kExitDone;
        if (is_done && (is_last || !was_broken)) continue;
        if (is_done)
            return Error{ErrorCode::cancelled,
                         "stopped by the operator; not carved after this: " + names_from(paths, i + 1)};
        if (!is_last) print_note("not carved after this: " + names_from(paths, i + 1));
        return carved;
    }
    return kExitDone;
}

}  // namespace psicarve::cli

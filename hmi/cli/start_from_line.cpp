// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/start_from_line.hpp"

#include <poll.h>
#include <termios.h>
#include <unistd.h>

#include <cstdio>
#include <string_view>

#include "hmi/cli/exit_code.hpp"
#include "hmi/report/status_json.hpp"

namespace psicarve::cli {
namespace {

constexpr int kAnswerLook_ms = 100;

std::string place_text(const gcode::Approach& approach, Axis axis, const char* unit) {
    char text[48];
    std::snprintf(text, sizeof text, "%.3f %s", approach.place[index_of(axis)], unit);
    return text;
}

std::string ways_text(const LineStart& start) {
    const gcode::Approach& approach = start.approach;
    std::string text = "  both heads go out to the end of their travel\n";
    if (approach.brings(Axis::psi)) {
        text += start.turns_shortest
                    ? "  psi turns\n"
                    : "  psi turns to " + place_text(approach, Axis::psi, "deg") + ", all turns\n";
    }
    if (approach.brings(Axis::y)) text += "  y goes to " + place_text(approach, Axis::y, "mm") + "\n";
    if (start.is_dry) return text + "  the heads stay out (dry run)\n";
    std::string heads;
    for (const Axis head : {Axis::r1, Axis::r2}) {
        if (!approach.brings(head)) continue;
        heads += (heads.empty() ? "" : ", ") + std::string{name_of(head)} + " to " +
                 place_text(approach, head, "mm");
    }
    return heads.empty() ? text : text + "  the heads come in: " + heads + "\n";
}

}  // namespace

std::string start_text(const LineStart& start) {
    const gcode::Approach& approach = start.approach;
    std::string text = "before line " + std::to_string(start.line) + " the machine does this:\n";
    if (!approach.is_needed() && !start.is_dry) text += "  nothing: no line before it moves anything\n";
    const bool turns_on = approach.is_spindle_on && !start.is_dry;
    if (start.is_spindle_on) {
        text += "  the spindle is on and stays on\n";
    } else if (turns_on) {
        text += "  the spindle goes on\n";
    }
    if (approach.outputs_on != 0 && !start.is_dry)
        text +=
            "  outputs go on: " + report::signals_text(levels_of(approach.outputs_on), kSwitchedMask) + "\n";
    if (approach.placed != 0 || start.is_dry) text += ways_text(start);
    if (!start.is_spindle_on && !turns_on) text += "  the spindle stays off until the program turns it on\n";
    text.pop_back();
    return text;
}

bool can_ask() noexcept {
    return ::isatty(STDIN_FILENO) != 0 && ::isatty(STDERR_FILENO) != 0;
}

Result<void> confirm_start(const OperatorBreak& operator_break) {
    (void)::tcflush(STDIN_FILENO, TCIFLUSH);  // nothing counts that was typed before the question
    print_question("begin so? yes or no: ");
    pollfd input{STDIN_FILENO, POLLIN, 0};
    while (::poll(&input, 1, kAnswerLook_ms) <= 0) {
        if (operator_break.was_asked()) break;
    }
    char typed[64] = {};
    const ssize_t count = operator_break.was_asked() ? 0 : ::read(STDIN_FILENO, typed, sizeof typed - 1);
    const std::string_view answer{typed, count > 0 ? static_cast<std::size_t>(count) : 0};
    if (answer == "yes\n" || answer == "y\n") return {};
    return Error{ErrorCode::cancelled, "not confirmed; nothing has moved"};
}

}  // namespace psicarve::cli

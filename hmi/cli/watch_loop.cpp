// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/watch_loop.hpp"

#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <ctime>

#include "hmi/cli/escaped_output.hpp"
#include "hmi/cli/exit_code.hpp"
#include "shared/base/printable.hpp"

namespace psicarve::cli {
namespace {

constexpr timespec kPeriod{0, 200'000'000};

/// Holds Ctrl-C and SIGTERM back while this lives, to be asked for.
class HeldSignals {
public:
    HeldSignals() {
        sigemptyset(&held_);
        sigaddset(&held_, SIGINT);
        sigaddset(&held_, SIGTERM);
        sigprocmask(SIG_BLOCK, &held_, &before_);
    }
    ~HeldSignals() { sigprocmask(SIG_SETMASK, &before_, nullptr); }
    HeldSignals(const HeldSignals&) = delete;
    HeldSignals& operator=(const HeldSignals&) = delete;

    /// Sleeps; true when one came.
    bool wait_for(const timespec& limit) const { return sigtimedwait(&held_, nullptr, &limit) > 0; }

private:
    sigset_t held_{};
    sigset_t before_{};
};

/// Draws over the previous text: up by its lines, then each line to its end.
void draw_in_place(const std::string& text, std::size_t& lines_drawn) {
    std::string screen;
    if (lines_drawn > 0) screen = "\033[" + std::to_string(lines_drawn) + "A";
    for (const char letter : printable(text)) {
        if (letter == '\n') screen += "\033[K";
        screen += letter;
    }
    screen += "\033[J";
    print_as_it_is(screen);
    lines_drawn = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

}  // namespace

Result<int> watch_loop(const std::function<Result<std::string>(bool as_line)>& show, bool as_json) {
    const bool is_terminal = isatty(STDOUT_FILENO) == 1 && !as_json;
    const HeldSignals signals;
    std::size_t lines_drawn = 0;
    std::string before;
    do {
        const auto text = show(!is_terminal);
        if (!text) return text.error();
        if (is_terminal) {
            draw_in_place(*text, lines_drawn);
        } else if (*text != before) {
            std::fputs(text->c_str(), stdout);
            before = *text;
        }
        if (const auto flushed = flush_output(); !flushed) return flushed.error();
    } while (!signals.wait_for(kPeriod));
    return kExitDone;
}

Result<int> show_or_watch(const std::function<Result<std::string>(bool as_line)>& show, bool is_watched,
                          bool as_json) {
    if (is_watched) return watch_loop(show, as_json);
    const auto text = show(false);
    if (!text) return text.error();
    std::fputs(text->c_str(), stdout);
    return kExitDone;
}

}  // namespace psicarve::cli

// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/progress_bar.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <utility>

namespace psicarve::cli {
namespace {

constexpr std::chrono::milliseconds kRedraw{100};
constexpr int kBarColumns = 24;
constexpr int kDefaultColumns = 80;
constexpr double kSecondsBeforeGuess = 0.5;
constexpr const char* kClearLine = "\r\033[K";

// The one line at the bottom of one terminal: all writers to standard error must know whether it is there.
std::atomic<bool> line_is_drawn{false};

int terminal_columns() {
    winsize size{};
    if (ioctl(STDERR_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return kDefaultColumns;
    return size.ws_col;
}

}  // namespace

void clear_progress_line() {
    if (!line_is_drawn.exchange(false)) return;
    std::fputs(kClearLine, stderr);
    std::fflush(stderr);
}

std::string clock_text(double seconds) {
    const long long whole = std::llround(std::clamp(seconds, 0.0, 1e12));
    char text[48];
    const long long hours = whole / 3600;
    const int minutes = static_cast<int>(whole / 60 % 60);
    const int rest = static_cast<int>(whole % 60);
    if (hours > 0) {
        std::snprintf(text, sizeof text, "%lld:%02d:%02d", hours, minutes, rest);
    } else {
        std::snprintf(text, sizeof text, "%d:%02d", minutes, rest);
    }
    return text;
}

std::string to_go_text(const TimeToGo& to_go) {
    return (to_go.is_about ? "about " : "") + clock_text(to_go.seconds);
}

std::string progress_line(const std::string& label, double done_ratio, const std::optional<TimeToGo>& to_go,
                          const std::string& detail, int width) {
    const double ratio = std::clamp(std::isfinite(done_ratio) ? done_ratio : 0.0, 0.0, 1.0);
    const auto filled = static_cast<std::size_t>(ratio * kBarColumns);
    char percent[16];
    std::snprintf(percent, sizeof percent, "%3d %%", static_cast<int>(ratio * 100.0));
    std::string line =
        label + "  [" + std::string(filled, '#') + std::string(kBarColumns - filled, '.') + "]  " + percent;
    if (to_go) line += "  " + to_go_text(*to_go) + " left";
    if (!detail.empty()) line += "  " + detail;
    if (width > 1 && line.size() >= static_cast<std::size_t>(width))
        line.resize(static_cast<std::size_t>(width - 1));
    return line;
}

ProgressBar::ProgressBar(std::string label)
    : label_(std::move(label)),
      begin_(std::chrono::steady_clock::now()),
      is_terminal_(isatty(STDERR_FILENO) == 1) {}

ProgressBar::~ProgressBar() {
    clear_progress_line();
}

void ProgressBar::relabel(const std::string& label) {
    if (label == label_) return;
    label_ = label;
    begin_ = std::chrono::steady_clock::now();
}

void ProgressBar::update(double done_ratio, const std::string& detail, std::optional<TimeToGo> to_go) {
    if (!is_terminal_) return;
    const auto now = std::chrono::steady_clock::now();
    if (now - last_drawn_ < kRedraw) return;
    last_drawn_ = now;
    const double elapsed_s = std::chrono::duration<double>(now - begin_).count();
    if (!to_go && done_ratio > 0.0 && elapsed_s > kSecondsBeforeGuess) {
        to_go = TimeToGo{elapsed_s * (1.0 - done_ratio) / done_ratio};
    }
    const std::string line = progress_line(label_, done_ratio, to_go, detail, terminal_columns());
    std::fprintf(stderr, "%s%s", kClearLine, line.c_str());
    std::fflush(stderr);
    line_is_drawn = true;
}

}  // namespace psicarve::cli

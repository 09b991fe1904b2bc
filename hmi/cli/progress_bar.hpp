// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <optional>
#include <string>

namespace psicarve::cli {

/// Shown as "3:12 left", or as "about 3:12 left".
struct TimeToGo {
    double seconds = 0.0;
    bool is_about = true;  ///< not planned to the end, or not planned at all
};

/// One line on a terminal: "carving  [######......]  42 %  3:12 left  layer 12/500". Writes nothing at all
/// when standard error is not a terminal. One at a time.
class ProgressBar {
public:
    explicit ProgressBar(std::string label);
    ~ProgressBar();
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    /// `to_go`: the core's value; without it the bar estimates from the time so far.
    void update(double done_ratio, const std::string& detail = {}, std::optional<TimeToGo> to_go = {});
    /// A new phase: the time so far starts anew.
    void relabel(const std::string& label);

private:
    std::string label_;
    std::chrono::steady_clock::time_point begin_;
    std::chrono::steady_clock::time_point last_drawn_{};
    bool is_terminal_ = false;
};

/// Removes the bar from the line, before other output to standard error; the next update draws it again.
void clear_progress_line();

/// The line itself, without control characters; `width` columns at most.
std::string progress_line(const std::string& label, double done_ratio, const std::optional<TimeToGo>& to_go,
                          const std::string& detail, int width);

/// "3:12", "about 3:12".
std::string to_go_text(const TimeToGo& to_go);

/// "0:07", "3:12", "1:05:00".
std::string clock_text(double seconds);

}  // namespace psicarve::cli

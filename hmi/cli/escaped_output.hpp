// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdio>
#include <string>

namespace psicarve::cli {

/// While it lives all that commands print to stdout leaves it as `printable` text: the one place that stands
/// between names in files, traces and segments, and a terminal. One at a time, in a program's main thread.
class EscapedOutput {
public:
    EscapedOutput();
    ~EscapedOutput();
    EscapedOutput(const EscapedOutput&) = delete;
    EscapedOutput& operator=(const EscapedOutput&) = delete;

private:
    std::string held_;  ///< of a letter whose other bytes are still to come
    std::FILE* before_;
    std::FILE* escaped_;
};

/// For what steers a terminal on purpose. What else it holds is `printable` already.
void print_as_it_is(const std::string& text);

}  // namespace psicarve::cli

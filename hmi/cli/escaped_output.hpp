// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdio>
#include <string>

namespace psicarve::cli {

/// While it lives all output of commands to stdout leaves as `printable` text: the one place between names in
/// files, traces and segments, and a terminal. One at a time, in a program's main thread.
class EscapedOutput {
public:
    EscapedOutput();
    ~EscapedOutput();
    EscapedOutput(const EscapedOutput&) = delete;
    EscapedOutput& operator=(const EscapedOutput&) = delete;

private:
    std::string held_;  ///< the begin of a letter whose other bytes are still to come
    std::FILE* before_;
    std::FILE* escaped_;
};

/// Prints a text that controls a terminal on purpose. Its other parts are `printable` already.
void print_as_it_is(const std::string& text);

}  // namespace psicarve::cli

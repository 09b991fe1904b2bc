// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

namespace psicarve::test {

/// A program with pipes at its input and output, gone when the object is.
class ChildProcess {
public:
    /// `environment`: NAME=VALUE, besides our own. `error_path`: for what it says besides.
    ChildProcess(const std::vector<std::string>& words, const std::vector<std::string>& environment,
                 const std::string& error_path);
    ~ChildProcess();
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;

    pid_t pid() const noexcept { return pid_; }
    void write_line(const std::string& line) const;
    /// Without its end; empty when there is none within the limit, or when the program has ended.
    std::string read_line();
    /// Ends it as nothing can be prevented from ending, and waits until it is gone.
    void send_signal(int number) const;
    void kill_now();
    /// Waits for its end; exit code, or 128 + signal.
    int wait();

private:
    pid_t pid_ = -1;
    int to_ = -1;
    int from_ = -1;
    std::string rest_;
};

/// Runs a program to its end; its exit code.
int run_to_end(const std::vector<std::string>& words, const std::vector<std::string>& environment);

}  // namespace psicarve::test

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <mutex>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "shared/segment/segment.hpp"
#include "tests/shared/temporary_folder.hpp"

namespace psicarve::test {

struct Outcome {
    int exit_code = -1;
    std::string out;
    std::string error;

    nlohmann::json json() const;
    std::size_t error_lines() const;
};

/// A program of ours with its two outputs piped to us. Killed at the end at the latest; dies with the test.
class RunningProgram {
public:
    RunningProgram(const std::string& name, const std::vector<std::string>& arguments);
    ~RunningProgram();
    RunningProgram(const RunningProgram&) = delete;
    RunningProgram& operator=(const RunningProgram&) = delete;

    pid_t pid() const { return pid_; }
    void send(int signal_number) const {
        if (!is_over_) kill(pid_, signal_number);
    }
    /// Whether it has ended by itself already.
    bool has_ended() const;
    /// Whether SIGSTOP holds it.
    bool is_stopped() const;
    /// Its exit code; 128 + signal when one ended it.
    int wait();
    /// What came of it, once it has ended.
    Outcome outcome();
    /// What it has said on standard output until now.
    std::string out_so_far() const {
        const std::lock_guard<std::mutex> lock(texts_mutex_);
        return texts_[0];
    }
    /// After wait().
    const std::string& out() const { return texts_[0]; }
    const std::string& error() const { return texts_[1]; }

private:
    void read_outputs();

    pid_t pid_ = -1;
    bool is_over_ = false;
    int exit_code_ = -1;
    std::array<int, 2> outputs_{};
    mutable std::mutex texts_mutex_;
    std::array<std::string, 2> texts_;
    std::thread reader_;
};

/// psicarve with these arguments, until it ends.
Outcome psicarve(const std::vector<std::string>& arguments);

std::vector<std::string> words_of(const std::string& text);

/// A folder and a segment of its own for each test.
class CliTest : public ::testing::Test {
protected:
    CliTest();
    ~CliTest() override;

    std::string file(const std::string& name) const;
    void write(const std::string& name, const std::string& text) const;
    static std::string text_of(const std::string& path);
    std::vector<std::string> files_in_folder() const;
    /// psicarve on this test's segment, until it ends.
    Outcome run(std::vector<std::string> arguments) const;
    /// Generous: a sanitizer on a busy machine.
    static bool eventually(const std::function<bool()>& condition);

    /// A box of 20 x 14 x `height_mm` that stands off its axis: no body of revolution.
    std::string box_stl(const std::string& name, double height_mm = 6.0) const;

    std::string segment_;
    TemporaryFolder temporary_;
    std::filesystem::path folder_{temporary_.path("")};
};

}  // namespace psicarve::test

// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/hmi/cli/program_run.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "shared/segment/segment.hpp"
#include "tests/places.hpp"
#include "tests/shared/child_signals.hpp"
#include "tests/shared/stale_segments.hpp"

namespace psicarve::test {

RunningProgram::RunningProgram(const std::string& name, const std::vector<std::string>& arguments) {
    std::array<int, 2> out_ends{};
    std::array<int, 2> error_ends{};
    if (pipe2(out_ends.data(), O_CLOEXEC) != 0 || pipe2(error_ends.data(), O_CLOEXEC) != 0) {
        ADD_FAILURE() << "no pipe";
    }
    std::vector<std::string> words{in_build("bin/" + std::string{name})};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    pid_ = fork();
    if (pid_ == 0) {
        be_a_usual_child();
        dup2(open("/dev/null", O_RDONLY), STDIN_FILENO);
        dup2(out_ends[1], STDOUT_FILENO);
        dup2(error_ends[1], STDERR_FILENO);
        execv(argv[0], argv.data());
        _exit(127);
    }
    close(out_ends[1]);
    close(error_ends[1]);
    outputs_ = {out_ends[0], error_ends[0]};
    reader_ = std::thread{[this] { read_outputs(); }};
}

RunningProgram::~RunningProgram() {
    send(SIGKILL);
    (void)wait();
}

bool RunningProgram::has_ended() const {
    if (is_over_) return true;
    siginfo_t ended{};
    return waitid(P_PID, static_cast<id_t>(pid_), &ended, WEXITED | WNOHANG | WNOWAIT) == 0 &&
           ended.si_pid == pid_;
}

bool RunningProgram::is_stopped() const {
    siginfo_t stopped{};
    return waitid(P_PID, static_cast<id_t>(pid_), &stopped, WSTOPPED | WNOHANG | WNOWAIT) == 0 &&
           stopped.si_pid == pid_;
}

int RunningProgram::wait() {
    if (!is_over_) {
        int status = 0;
        waitpid(pid_, &status, 0);
        exit_code_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
        is_over_ = true;
        reader_.join();
    }
    return exit_code_;
}

Outcome RunningProgram::outcome() {
    const int exit_code = wait();
    return {exit_code, out(), error()};
}

void RunningProgram::read_outputs() {
    std::array<pollfd, 2> waited{pollfd{outputs_[0], POLLIN, 0}, pollfd{outputs_[1], POLLIN, 0}};
    while (waited[0].fd >= 0 || waited[1].fd >= 0) {
        if (poll(waited.data(), waited.size(), -1) < 0 && errno != EINTR) return;
        for (std::size_t i = 0; i < waited.size(); ++i) {
            if (waited[i].fd < 0 || waited[i].revents == 0) continue;
            std::array<char, 65536> bytes;
            const ssize_t got = read(waited[i].fd, bytes.data(), bytes.size());
            if (got > 0) {
                const std::lock_guard<std::mutex> lock(texts_mutex_);
                texts_[i].append(bytes.data(), static_cast<std::size_t>(got));
            } else {
                close(waited[i].fd);
                waited[i].fd = -1;
            }
        }
    }
}

nlohmann::json Outcome::json() const {
    return nlohmann::json::parse(out, nullptr, false);
}

std::size_t Outcome::error_lines() const {
    return static_cast<std::size_t>(std::count(error.begin(), error.end(), '\n'));
}

Outcome psicarve(const std::vector<std::string>& arguments) {
    return RunningProgram{"psicarve", arguments}.outcome();
}

std::vector<std::string> words_of(const std::string& text) {
    std::istringstream stream{text};
    return {std::istream_iterator<std::string>{stream}, {}};
}

CliTest::CliTest() {
    remove_stale_segments_once();
    static std::atomic<int> count{0};
    segment_ = "/" + named_after_this_process(kCliTestSegmentPrefix) + "-" + std::to_string(++count);
}

CliTest::~CliTest() {
    (void)Segment::remove(segment_);
}

std::string CliTest::file(const std::string& name) const {
    return temporary_.path(name);
}
void CliTest::write(const std::string& name, const std::string& text) const {
    std::ofstream{file(name), std::ios::binary} << text;
}

std::string CliTest::text_of(const std::string& path) {
    std::ifstream stream{path, std::ios::binary};
    return {std::istreambuf_iterator<char>{stream}, {}};
}

std::vector<std::string> CliTest::files_in_folder() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator{folder_}) {
        names.push_back(entry.path().filename().string());
    }
    std::sort(names.begin(), names.end());
    return names;
}

Outcome CliTest::run(std::vector<std::string> arguments) const {
    arguments.insert(arguments.end(), {"--segment", segment_});
    return psicarve(arguments);
}

bool CliTest::eventually(const std::function<bool()>& condition) {
    constexpr std::chrono::seconds kLimit{120};
    const auto give_up = std::chrono::steady_clock::now() + kLimit;
    while (!condition()) {
        if (std::chrono::steady_clock::now() > give_up) return false;
        std::this_thread::sleep_for(std::chrono::milliseconds{2});
    }
    return true;
}

std::string CliTest::box_stl(const std::string& name, double height_mm) const {
    const std::array<double, 3> low{-10.0, -7.0, 0.0};
    const std::array<double, 3> high{10.0, 7.0, height_mm};
    std::ofstream stl{file(name)};
    stl << "solid box\n";
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (const bool is_high : {false, true}) {
            const std::size_t u = (axis + 1) % 3;
            const std::size_t v = (axis + 2) % 3;
            std::array<std::array<double, 3>, 4> corners{};
            for (std::size_t i = 0; i < 4; ++i) {
                corners[i][axis] = is_high ? high[axis] : low[axis];
                corners[i][u] = (i == 1 || i == 2) ? high[u] : low[u];
                corners[i][v] = i >= 2 ? high[v] : low[v];
            }
            if (!is_high) std::swap(corners[1], corners[3]);
            for (const auto& facet :
                 {std::array<std::size_t, 3>{0, 1, 2}, std::array<std::size_t, 3>{0, 2, 3}}) {
                stl << "facet normal 0 0 0\nouter loop\n";
                for (const std::size_t i : facet) {
                    stl << "vertex " << corners[i][0] << " " << corners[i][1] << " " << corners[i][2] << "\n";
                }
                stl << "endloop\nendfacet\n";
            }
        }
    }
    stl << "endsolid box\n";
    return file(name);
}

}  // namespace psicarve::test

// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/machine/latency_probe.hpp"

#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <nlohmann/json.hpp>
#include <optional>

#include "hmi/machine/child_start.hpp"
#include "hmi/machine/core_process.hpp"
#include "hmi/machine/unique_fd.hpp"

namespace psicarve::machine {
namespace {

constexpr int kPoll_ms = 100;

/// The measuring core; the destructor ends it and waits for its end.
class Probe {
public:
    explicit Probe(pid_t pid) noexcept : pid_(pid) {}
    Probe(const Probe&) = delete;
    Probe& operator=(const Probe&) = delete;
    ~Probe() {
        if (pid_ <= 0) return;
        kill(pid_, SIGKILL);
        waitpid(pid_, nullptr, 0);
    }
    void tell_to_end() const noexcept { kill(pid_, SIGTERM); }
    int wait_exit() noexcept {
        int status = 0;
        waitpid(pid_, &status, 0);
        pid_ = -1;
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }

private:
    pid_t pid_;
};

/// Whole lines of a pipe, as they come.
class LineReader {
public:
    explicit LineReader(int descriptor) noexcept : descriptor_(descriptor) {}

    /// Waits a moment for more. False at the end of all.
    bool read_more() {
        pollfd wait{.fd = descriptor_, .events = POLLIN, .revents = 0};
        if (poll(&wait, 1, kPoll_ms) <= 0) return true;
        char piece[4096];
        const ssize_t bytes = read(descriptor_, piece, sizeof piece);
        if (bytes > 0) text_.append(piece, static_cast<std::size_t>(bytes));
        return bytes > 0;
    }
    std::optional<std::string> next_line() {
        const std::size_t end = text_.find('\n');
        if (end == std::string::npos) return std::nullopt;
        std::string line = text_.substr(0, end);
        text_.erase(0, end + 1);
        return line;
    }

private:
    int descriptor_;
    std::string text_;
};

std::optional<LatencyProgress> progress_from(const std::string& line) {
    const auto json = nlohmann::json::parse(line, nullptr, false);
    if (!json.is_object() || !json.contains("seconds")) return std::nullopt;
    return LatencyProgress{.seconds = json.value("seconds", 0U),
                           .ticks = json.value("ticks", std::uint64_t{0}),
                           .missed = json.value("missed", std::uint64_t{0}),
                           .max_ns = json.value("max_ns", std::int64_t{0})};
}

std::vector<std::string> arguments_of(const LatencyOptions& options, const std::string& program) {
    std::vector<std::string> words{program,
                                   "--measure-latency",
                                   "--seconds",
                                   std::to_string(options.seconds),
                                   "--period-us",
                                   std::to_string(options.period_us),
                                   "--priority",
                                   std::to_string(options.priority),
                                   "--exit-with-parent"};
    if (!options.cpu.empty()) words.insert(words.end(), {"--cpu", options.cpu});
    return words;
}

}  // namespace

double LatencyResult::late_us(double share) const noexcept {
    const double wanted = share * static_cast<double>(ticks);
    double before = 0.0;
    for (const auto& [late, count] : bins) {
        const auto here = static_cast<double>(count);
        if (before + here >= wanted && here > 0.0) return late + (wanted - before) / here;
        before += here;
    }
    return bins.empty() ? 0.0 : bins.back().first + 1.0;
}

Result<LatencyResult> latency_result_from(std::string_view line) {
    const auto json = nlohmann::json::parse(line, nullptr, false);
    const auto broken = [] { return Error{ErrorCode::no_core, "psicarve-rtcore gave no measurement"}; };
    if (!json.is_object() || !json.value("result", false)) return broken();
    try {
        LatencyResult result;
        result.ticks = json.at("ticks");
        result.missed = json.at("missed");
        result.max_ns = json.at("max_ns");
        result.page_faults =
            json.at("minor_faults").get<std::uint64_t>() + json.at("major_faults").get<std::uint64_t>();
        result.preemptions = json.at("preemptions");
        result.cpu = json.at("cpu");
        result.priority = json.at("priority");
        result.refused = json.at("refused").get<std::vector<std::string>>();
        result.bins = json.at("histogram_us").get<decltype(result.bins)>();
        return result;
    } catch (const nlohmann::json::exception&) {
        return broken();
    }
}

Result<LatencyResult> measure_latency(const LatencyOptions& options,
                                      const std::function<void(const LatencyProgress&)>& progress,
                                      const std::function<bool()>& must_end) {
    const auto program = find_core_program();
    if (!program) {
        return Error{ErrorCode::no_core, "psicarve-rtcore: not found beside psicarve nor in PATH"};
    }
    auto pipe = open_pipe();
    if (!pipe) return pipe.error();
    const auto pid =
        start_child({.arguments = arguments_of(options, *program), .output = pipe->write_end.get()});
    if (!pid) return pid.error();
    pipe->write_end.reset();
    Probe probe{*pid};
    LineReader lines{pipe->read_end.get()};
    std::string last;
    bool is_told = false;
    while (lines.read_more()) {
        while (auto line = lines.next_line()) {
            if (const auto now = progress_from(*line)) progress(*now);
            last = std::move(*line);
        }
        // Not before its first line: until then a signal would end it without a word.
        if (!is_told && !last.empty() && must_end()) {
            probe.tell_to_end();
            is_told = true;
        }
    }
    const int exit_code = probe.wait_exit();
    if (exit_code != 0) {
        return Error{ErrorCode::no_core,
                     "psicarve-rtcore could not measure, its exit code is " + std::to_string(exit_code)};
    }
    return latency_result_from(last);
}

}  // namespace psicarve::machine

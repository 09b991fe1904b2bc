// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/machine/core_process.hpp"

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <climits>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <thread>
#include <utility>

#include "hmi/machine/child_start.hpp"
#include "shared/machine/command.hpp"

namespace psicarve::machine {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

constexpr const char* kProgramName = "psicarve-rtcore";
constexpr milliseconds kProcessPoll{2};
constexpr milliseconds kStartLimit{20'000};
constexpr milliseconds kShutdownLimit{3'000};
constexpr milliseconds kTerminateLimit{3'000};
constexpr std::size_t kMessageBytes = 4096;
constexpr int kExitDone = 0;
constexpr int kExitBadInput = 3;
constexpr int kExitAlarm = 4;
constexpr int kSignalExitBase = 128;

std::vector<std::string> arguments_of(const CoreLaunch& launch, const std::string& program) {
    std::vector<std::string> arguments{
        program, "--segment",  launch.segment_name, "--port",
        "sim",   "--no-state", "--clock",           launch.on_real_clock ? "real" : "virtual"};
    const bool is_usual_capacity =
        launch.capacity_layers == kDefaultCapacityLayers && launch.capacity_points == kDefaultCapacityPoints;
    if (!is_usual_capacity) {
        arguments.emplace_back("--capacity");
        arguments.push_back(std::to_string(launch.capacity_layers) + "x" +
                            std::to_string(launch.capacity_points));
    }
    if (launch.replays_program) arguments.emplace_back("--replay-program");
    if (launch.no_estimate) arguments.emplace_back("--no-estimate");
    if (!launch.outlives_us) arguments.emplace_back("--exit-with-parent");
    const auto add = [&arguments](const char* option, const std::string& value) {
        if (value.empty()) return;
        arguments.emplace_back(option);
        arguments.push_back(value);
    };
    add("--profile", launch.profile_path);
    add("--replay", launch.replay_path);
    add("--group", launch.group);
    add("--layer-times", launch.layer_times_path);
    add("--point-times", launch.point_times_path);
    for (const std::string& path : launch.trace_paths) add("--trace", path);
    return arguments;
}

}  // namespace

std::optional<std::string> find_program(const std::string& name) {
    namespace fs = std::filesystem;
    std::vector<fs::path> folders;
    std::error_code error;
    const fs::path self = fs::read_symlink("/proc/self/exe", error);
    if (!error) folders.push_back(self.parent_path());
    if (const char* path = std::getenv("PATH"); path != nullptr) {
        std::istringstream entries{path};
        for (std::string entry; std::getline(entries, entry, ':');)
            folders.emplace_back(entry.empty() ? "." : entry);
    }
    for (const fs::path& folder : folders) {
        const fs::path candidate = folder / name;
        if (fs::is_regular_file(candidate, error) && access(candidate.c_str(), X_OK) == 0)
            return candidate.string();
    }
    return std::nullopt;
}

std::optional<std::string> find_core_program() {
    return find_program(kProgramName);
}

CoreProcess::CoreProcess(pid_t pid, UniqueFd output, const CoreLaunch& launch)
    : pid_(pid),
      output_(std::move(output)),
      segment_name_(launch.segment_name),
      is_private_(launch.is_private),
      is_replay_(!launch.replay_path.empty()) {}

CoreProcess::CoreProcess(CoreProcess&& other) noexcept
    : pid_(std::exchange(other.pid_, -1)),
      exit_code_(std::exchange(other.exit_code_, std::nullopt)),
      output_(std::move(other.output_)),
      segment_name_(std::move(other.segment_name_)),
      is_private_(std::exchange(other.is_private_, false)),
      is_replay_(other.is_replay_) {}

Result<CoreProcess> CoreProcess::start(const CoreLaunch& launch) {
    const auto program = find_core_program();
    if (!program) {
        return Error{ErrorCode::no_core,
                     std::string{kProgramName} + ": not found beside psicarve nor in PATH; install it there"};
    }
    auto output = open_memory_file("core-output");
    if (!output) return output.error();
    const auto pid = start_child({.arguments = arguments_of(launch, *program),
                                  .output = output->get(),
                                  .errors = output->get(),
                                  .inherited = launch.inherited_fds});
    if (!pid) return pid.error();
    CoreProcess core{*pid, std::move(output).value(), launch};
    if (const auto serving = core.wait_until_it_serves(); !serving) return serving.error();
    return core;
}

Result<void> CoreProcess::wait_until_it_serves() {
    const auto give_up = Clock::now() + kStartLimit;
    while (true) {
        if (poll_exit()) {
            // A short replay may be over before we looked; the caller judges its result.
            if (is_replay_ && (exit_code_ == kExitDone || exit_code_ == kExitAlarm)) return {};
            return failure();
        }
        const auto segment = Segment::attach(segment_name_);
        if (segment && segment->core_pid() == static_cast<std::uint32_t>(pid_)) return {};
        if (Clock::now() > give_up) {
            return Error{ErrorCode::no_core, std::string{kProgramName} + " (pid " + std::to_string(pid_) +
                                                 ") did not begin to serve segment " + segment_name_ + ": " +
                                                 messages()};
        }
        std::this_thread::sleep_for(kProcessPoll);
    }
}

Error CoreProcess::failure() const {
    const std::string said = messages();
    const ErrorCode code = exit_code_ == kExitBadInput ? ErrorCode::bad_input : ErrorCode::no_core;
    if (!said.empty()) return Error{code, said};
    return Error{code, std::string{kProgramName} + " ended with exit code " +
                           std::to_string(exit_code_.value_or(0)) + " and said nothing"};
}

bool CoreProcess::poll_exit() {
    if (exit_code_ || pid_ < 0) return true;
    int status = 0;
    if (waitpid(pid_, &status, WNOHANG) != pid_) return false;
    exit_code_ = WIFEXITED(status) ? WEXITSTATUS(status) : kSignalExitBase + WTERMSIG(status);
    return true;
}

std::optional<int> CoreProcess::wait_exit(milliseconds limit) {
    const auto give_up = Clock::now() + limit;
    while (!poll_exit()) {
        if (Clock::now() > give_up) return std::nullopt;
        std::this_thread::sleep_for(kProcessPoll);
    }
    return exit_code_;
}

void CoreProcess::terminate() noexcept {
    if (pid_ > 0 && !poll_exit()) kill(pid_, SIGTERM);
}

bool CoreProcess::agrees_to_end() {
    auto segment = Segment::attach(segment_name_);
    return segment &&
           send_command(*segment, Command{CommandKind::shutdown, 0, 0.0, 0}, kShutdownLimit).has_value();
}

bool CoreProcess::end_while(const std::function<bool()>& goes_on) {
    if (pid_ < 0 || poll_exit()) return true;
    if (!agrees_to_end()) return false;
    while (!poll_exit()) {
        if (!goes_on()) return false;
        std::this_thread::sleep_for(kProcessPoll);
    }
    return true;
}

void CoreProcess::end() noexcept {
    if (pid_ < 0) return;
    if (!poll_exit()) {
        if (!agrees_to_end() || !wait_exit(kShutdownLimit)) {
            terminate();
            if (!wait_exit(kTerminateLimit)) {
                kill(pid_, SIGKILL);
                // No process outlives that; the limit only guards against one stuck in the kernel.
                (void)wait_exit(kTerminateLimit);
            }
        }
    }
    if (is_private_) (void)Segment::remove(segment_name_);
    pid_ = -1;
}

std::string CoreProcess::messages() const {
    std::string said = tail_of(output_.get(), kMessageBytes);
    while (!said.empty() && (said.back() == '\n' || said.back() == ' ')) said.pop_back();
    return said;
}

}  // namespace psicarve::machine

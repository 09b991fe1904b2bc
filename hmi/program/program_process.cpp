// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/program/program_process.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <span>
#include <sstream>
#include <string_view>
#include <utility>
#include <vector>

#include "hmi/machine/child_start.hpp"
#include "hmi/machine/core_process.hpp"
#include "hmi/machine/unique_fd.hpp"
#include "shared/file/atomic_file.hpp"

namespace psicarve::program {
namespace {

constexpr const char* kRunner = "psicarve";
constexpr std::size_t kLinesTold = 6;
constexpr std::size_t kBytesTold = 8192;
constexpr std::size_t kLogsKept = 20;
/// Of all windows of this process: no two of its programs share a file.
std::atomic<std::uint64_t> g_start_count{0};
constexpr std::string_view kLogEnding = ".run.log";

std::string tail_of(const std::string& path) {
    std::ifstream file{path, std::ios::binary | std::ios::ate};
    if (!file) return {};
    const auto bytes = static_cast<std::streamoff>(file.tellg());
    file.seekg(std::max<std::streamoff>(0, bytes - static_cast<std::streamoff>(kBytesTold)));
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

/// All but the newest. What cannot be removed stays.
void remove_old_logs(const std::string& folder) {
    namespace fs = std::filesystem;
    std::error_code error;
    std::vector<std::pair<fs::file_time_type, fs::path>> logs;
    for (fs::directory_iterator at{folder, error}; !error && at != fs::directory_iterator{};
         at.increment(error)) {
        const std::string name = at->path().filename().string();
        std::error_code unknown;
        const auto written = at->last_write_time(unknown);
        if (!unknown && name.size() > kLogEnding.size() && name.ends_with(kLogEnding))
            logs.emplace_back(written, at->path());
    }
    std::sort(logs.begin(), logs.end());
    for (std::size_t i = 0; i + kLogsKept < logs.size(); ++i) {
        std::string path = logs[i].second.string();
        fs::remove(path, error);
        path.resize(path.size() - kLogEnding.size());
        // Of a window that was closed before its program ended.
        for (const char* ending : {".toml", ".ngc"}) fs::remove(path + ending, error);
    }
}

void remove_used(const RunFiles& files) {
    std::error_code error;
    for (const std::string& path : {files.profile(), files.block()}) std::filesystem::remove(path, error);
}

Result<void> make_folder(const std::string& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (!error) std::filesystem::permissions(folder, std::filesystem::perms::owner_all, error);
    if (!error) {
        remove_old_logs(folder);
        return {};
    }
    return Error{ErrorCode::out_of_room, folder + ": cannot be made: " + error.message()};
}

Error changed_since(const std::string& path) {
    return bad_input(path + ": has been changed since it was read; decode it again");
}

/// A zero may be set between the look at the path and the start.
Result<void> require_same_offsets(const RunRequest& request, const Profile& profile) {
    if (!request.offsets) return {};
    DecodeRequest asked;
    asked.profile = profile;
    asked.segment_name = request.segment_name;
    asked.is_simulator = request.is_simulator;
    const auto now = offsets_for(asked);
    if (!now) return now.error();
    if (*now == *request.offsets) return {};
    return bad_input("the work offsets have been changed since it was read; decode it again");
}

Error given_up() {
    return {ErrorCode::cancelled, "interrupted; nothing has moved"};
}

ProgramProcess::Ended refusal(const Error& why) {
    return {false, why.message, why.message, {}};
}

}  // namespace

std::string last_lines(const std::string& text, std::size_t most) {
    std::vector<std::string> lines;
    std::istringstream all{text};
    for (std::string line; std::getline(all, line);) {
        if (!line.empty()) lines.push_back(line);
    }
    std::string last;
    for (std::size_t i = lines.size() - std::min(lines.size(), most); i < lines.size(); ++i)
        last += (last.empty() ? "" : "\n") + lines[i];
    return last;
}

std::string last_said(const std::string& text) {
    constexpr std::string_view kName = "psicarve: ";
    const std::string line = last_lines(text, 1);
    return line.rfind(kName, 0) == 0 ? line.substr(kName.size()) : line;
}

ProgramProcess::Begun ProgramProcess::start(const RunFiles& files, RunRequest request, const Profile& profile,
                                            const DecodeProgress& progress) {
    const auto program = machine::find_program(kRunner);
    if (!program) {
        return {std::nullopt, refusal({ErrorCode::no_core, std::string{kRunner} +
                                                               ": not found beside psicarve-hmi nor in PATH; "
                                                               "install it there"})};
    }
    if (const auto made = make_folder(files.folder); !made) return {std::nullopt, refusal(made.error())};
    const std::string toml = profile_to_toml(profile);
    const auto written = write_file_atomically(files.profile(), std::as_bytes(std::span{toml}));
    if (!written) return {std::nullopt, refusal(written.error())};
    request.profile_path = files.profile();
    if (request.state) {
        const auto now = gcode::state_of_program(request.file);
        if (!now) return {std::nullopt, refusal(now.error())};
        if (*now != *request.state) return {std::nullopt, refusal(changed_since(request.file))};
    }
    if (const auto same = require_same_offsets(request, profile); !same)
        return {std::nullopt, refusal(same.error())};
    const machine::UniqueFd log{
        open(files.log().c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_APPEND | O_NOFOLLOW | O_CLOEXEC, 0600)};
    if (log.get() < 0)
        return {std::nullopt, refusal({ErrorCode::out_of_room, files.log() + ": " + std::strerror(errno)})};
    if (progress.is_cancelled.load()) return {std::nullopt, refusal(given_up())};
    const auto started = machine::start_child({.arguments = arguments_of(*program, request),
                                               .output = log.get(),
                                               .errors = log.get(),
                                               .has_own_session = true});
    if (!started) return {std::nullopt, refusal(started.error())};
    return {*started, {}};
}

void ProgramProcess::note_start() {
    state_ = State::starting;
    files_.name = name_ + "-" + std::to_string(++g_start_count);
    progress_ = std::make_shared<DecodeProgress>();
    is_interrupted_ = false;
}

void ProgramProcess::begin(RunRequest request, const Profile& profile) {
    if (state_ != State::none) return;
    note_start();
    starting_.begin([files = files_, request = std::move(request), profile, progress = progress_] {
        return start(files, request, profile, *progress);
    });
}

void ProgramProcess::begin_block(const std::string& block, RunRequest request,
                                 const DecodeRequest& judged_by) {
    if (state_ != State::none) return;
    note_start();
    request.file = files_.block();
    request.is_typed = true;
    starting_.begin(
        [files = files_, block, request = std::move(request), judged_by, progress = progress_]() -> Begun {
            if (const auto made = make_folder(files.folder); !made)
                return {std::nullopt, refusal(made.error())};
            const std::string text = block + "\nM2\n";
            const auto written = write_file_atomically(files.block(), std::as_bytes(std::span{text}));
            if (!written) return {std::nullopt, refusal(written.error())};
            DecodeRequest judged = judged_by;
            judged.path = files.block();
            const auto decoded = decode(judged, *progress);
            if (progress->is_cancelled.load()) return {std::nullopt, refusal(given_up())};
            if (!decoded) return {std::nullopt, refusal(decoded.error())};
            if (!(*decoded)->is_right()) return {std::nullopt, {false, {}, {}, (*decoded)->problems}};
            RunRequest checked = request;
            checked.state = (*decoded)->state;
            checked.is_simulator = judged.is_simulator;
            checked.offsets = (*decoded)->offsets;
            return start(files, std::move(checked), judged.profile, *progress);
        });
}

void ProgramProcess::give_up() noexcept {
    if (progress_) progress_->is_cancelled.store(true);
    interrupt_once();
}

/// A second time would be an emergency stop. Of a process that was not waited for the number is still its
/// own.
void ProgramProcess::interrupt_once() noexcept {
    if (!pid_ || is_interrupted_) return;
    is_interrupted_ = true;
    (void)::kill(*pid_, SIGINT);
}

std::optional<ProgramProcess::Ended> ProgramProcess::poll() {
    if (auto begun = starting_.take()) {
        if (!begun->pid) {
            state_ = State::none;
            return std::move(begun->refused);
        }
        pid_ = begun->pid;
        state_ = State::running;
        if (progress_->is_cancelled.load()) interrupt_once();
    }
    if (pid_ && !exit_code_) {
        int status = 0;
        const pid_t ended = waitpid(*pid_, &status, WNOHANG);
        if (ended == 0) return std::nullopt;
        exit_code_ = ended > 0 && WIFEXITED(status) ? WEXITSTATUS(status) : -1;
        pid_.reset();
        reading_.begin([files = files_] {
            remove_used(files);
            return tail_of(files.log());
        });
    }
    const auto said = reading_.take();
    if (!said) return std::nullopt;
    const bool is_done = *exit_code_ == 0;
    exit_code_.reset();
    state_ = State::none;
    // It was interrupted before it could say so.
    if (is_interrupted_ && said->empty()) return refusal(given_up());
    return Ended{is_done, last_said(*said), last_lines(*said, kLinesTold), {}};
}

}  // namespace psicarve::program

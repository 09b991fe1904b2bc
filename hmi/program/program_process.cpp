// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/program/program_process.hpp"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
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

std::string tail_of(const std::string& path) {
    std::ifstream file{path, std::ios::binary | std::ios::ate};
    if (!file) return {};
    const auto bytes = static_cast<std::streamoff>(file.tellg());
    file.seekg(std::max<std::streamoff>(0, bytes - static_cast<std::streamoff>(kBytesTold)));
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

Result<void> make_folder(const std::string& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (!error) return {};
    return Error{ErrorCode::out_of_room, folder + ": cannot be made: " + error.message()};
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

ProgramProcess::Begun ProgramProcess::start(const RunFiles& files, RunRequest request,
                                            const Profile& profile) {
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
    const machine::UniqueFd log{
        open(files.log().c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_APPEND | O_CLOEXEC, 0600)};
    if (log.get() < 0)
        return {std::nullopt, refusal({ErrorCode::out_of_room, files.log() + ": " + std::strerror(errno)})};
    const auto started = machine::start_child({.arguments = arguments_of(*program, request),
                                               .output = log.get(),
                                               .errors = log.get(),
                                               .has_own_session = true});
    if (!started) return {std::nullopt, refusal(started.error())};
    return {*started, {}};
}

void ProgramProcess::begin(RunRequest request, const Profile& profile) {
    state_ = State::starting;
    starting_.begin(
        [files = files_, request = std::move(request), profile] { return start(files, request, profile); });
}

void ProgramProcess::begin_block(const std::string& block, RunRequest request,
                                 const DecodeRequest& judged_by) {
    state_ = State::starting;
    request.file = files_.block();
    starting_.begin([files = files_, block, request = std::move(request), judged_by]() -> Begun {
        if (const auto made = make_folder(files.folder); !made) return {std::nullopt, refusal(made.error())};
        const std::string text = block + "\nM2\n";
        const auto written = write_file_atomically(files.block(), std::as_bytes(std::span{text}));
        if (!written) return {std::nullopt, refusal(written.error())};
        DecodeRequest judged = judged_by;
        judged.path = files.block();
        DecodeProgress progress;
        const auto decoded = decode(judged, progress);
        if (!decoded) return {std::nullopt, refusal(decoded.error())};
        if (!(*decoded)->is_right()) return {std::nullopt, {false, {}, {}, (*decoded)->problems}};
        return start(files, request, judged.profile);
    });
}

std::optional<ProgramProcess::Ended> ProgramProcess::poll() {
    if (auto begun = starting_.take()) {
        if (!begun->pid) {
            state_ = State::none;
            return std::move(begun->refused);
        }
        pid_ = begun->pid;
        state_ = State::running;
    }
    if (pid_ && !exit_code_) {
        int status = 0;
        const pid_t ended = waitpid(*pid_, &status, WNOHANG);
        if (ended == 0) return std::nullopt;
        exit_code_ = ended > 0 && WIFEXITED(status) ? WEXITSTATUS(status) : -1;
        pid_.reset();
        reading_.begin([path = files_.log()] { return tail_of(path); });
    }
    const auto said = reading_.take();
    if (!said) return std::nullopt;
    const bool is_done = *exit_code_ == 0;
    exit_code_.reset();
    state_ = State::none;
    return Ended{is_done, last_said(*said), last_lines(*said, kLinesTold), {}};
}

}  // namespace psicarve::program

// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/log_file.hpp"

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <system_error>
#include <utility>

namespace psicarve::session {
namespace {

namespace fs = std::filesystem;

constexpr long kMsPerSecond = 1000;

const char* name_of_severity(Severity severity) {
    if (severity == Severity::alarm) return "alarm";
    return severity == Severity::warning ? "warning" : "info";
}

std::string utc_text(std::chrono::system_clock::time_point time) {
    const auto ms = std::chrono::duration_cast<std::chrono::milliseconds>(time.time_since_epoch()).count();
    const std::time_t second = ms / kMsPerSecond;
    std::tm utc{};
    gmtime_r(&second, &utc);
    char text[64];
    const std::size_t length = std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%S", &utc);
    std::snprintf(text + length, sizeof text - length, ".%03ldZ", ms % kMsPerSecond);
    return text;
}

}  // namespace

std::string log_line(const Message& message) {
    char kind[16];
    std::snprintf(kind, sizeof kind, " %-8s", name_of_severity(message.severity));
    const bool is_timeless = message.is_from_before && message.time == decltype(message.time){};
    const std::string time = is_timeless ? "(time not known)        " : utc_text(message.time);  // as wide
    std::string line = time + kind + in_english(message.what);
    if (!message.axes.empty()) line += " (" + message.axes + ")";
    if (!message.remedy.is_empty()) line += ": " + in_english(message.remedy);
    std::replace(line.begin(), line.end(), '\n', ' ');
    return line + "\n";
}

std::string log_text(const std::deque<Message>& messages) {
    std::string text;
    for (const Message& message : messages) text += log_line(message);
    return text;
}

std::string state_folder(const char* xdg_state_home, const char* home) {
    if (xdg_state_home != nullptr && *xdg_state_home == '/') return std::string{xdg_state_home} + "/psicarve";
    if (home != nullptr && *home == '/') return std::string{home} + "/.local/state/psicarve";
    return {};
}

Result<void> LogFile::add(const std::string& lines) {
    const auto cannot = [this](const std::string& why) {
        return Error{ErrorCode::bad_input, path_ + ": cannot be written: " + why};
    };
    std::error_code error;
    fs::create_directories(fs::path{path_}.parent_path(), error);
    if (error) return cannot(error.message());
    const std::uintmax_t bytes = fs::file_size(path_, error);
    if (!error && bytes + lines.size() > most_bytes_) {
        for (int old = kOldFiles; old > 0; --old) {
            const std::string from = old == 1 ? path_ : path_ + "." + std::to_string(old - 1);
            fs::rename(from, path_ + "." + std::to_string(old), error);
        }
    }
    std::ofstream file{path_, std::ios::app | std::ios::binary};
    file << lines << std::flush;
    if (!file) return cannot("is the disk full, or the folder another user's?");
    return {};
}

LogKeeper::LogKeeper(const std::string& folder, PendingSaves saves)
    : folder_(folder), file_(folder + "/psicarve-hmi.log"), saves_(std::move(saves)) {
    if (!folder_.empty()) queue_.emplace();
}

LogKeeper::~LogKeeper() {
    queue_.reset();
    if (folder_.empty()) return;
    const PendingSaves::Entry save = saves_.begin(file_.path());
    (void)flush();
}

Result<void> LogKeeper::flush() {
    std::string lines;
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        lines.swap(pending_);
    }
    return lines.empty() ? Result<void>{} : file_.add(lines);
}

void LogKeeper::poll(MessageLog& log) {
    if (!queue_) return;
    queue_->deliver();
    const auto& all = log.messages();
    const auto fresh = std::min<std::uint64_t>(log.count() - seen_, all.size());
    if (fresh == 0) return;
    seen_ = log.count();
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        for (auto i = all.size() - fresh; i < all.size(); ++i) {
            if (!all[i].is_from_before || all[i].is_standing) pending_ += log_line(all[i]);
        }
    }
    queue_->post(saves_.noted(file_.path(), [this, &log]() -> BackgroundQueue::Finish {
        const auto written = flush();
        if (written) return {};
        return [this, &log, why = written.error().message] {
            if (!std::exchange(has_complained_, true))
                log.add(Severity::warning, phrase("The log is not kept: %1", why));
        };
    }));
}

}  // namespace psicarve::session

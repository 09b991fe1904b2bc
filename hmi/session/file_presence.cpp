// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/file_presence.hpp"

#include <utility>

namespace psicarve::session {
namespace {

FilePresence::Seen look_at(const std::string& path) {
    std::error_code problem;
    const auto written = std::filesystem::last_write_time(path, problem);
    if (problem) return {FilePresence::State::gone, {}};
    return {FilePresence::State::there, written};
}

}  // namespace

void FilePresence::look(std::vector<std::string> paths) {
    lane_.post([this, paths = std::move(paths)]() -> WorkLane::Finish {
        std::map<std::string, Seen> found;
        for (const std::string& path : paths) found[path] = look_at(path);
        return [this, found = std::move(found)] {
            for (const auto& [path, seen] : found) seen_[path] = seen;
        };
    });
}

FilePresence::Seen FilePresence::seen(const std::string& path) const {
    const auto found = seen_.find(path);
    return found == seen_.end() ? Seen{} : found->second;
}

}  // namespace psicarve::session

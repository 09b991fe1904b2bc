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

/// The folder, the one that it is in, and so on.
std::vector<std::string> folders_above(const std::string& folder) {
    std::vector<std::string> folders;
    std::filesystem::path here = folder;
    while (!here.empty()) {
        folders.push_back(here.string());
        if (here == here.parent_path()) break;
        here = here.parent_path();
    }
    return folders;
}

}  // namespace

void FilePresence::look(std::vector<std::string> paths) {
    queue_.post([this, paths = std::move(paths)]() -> BackgroundQueue::Finish {
        std::map<std::string, Seen> found;
        for (const std::string& path : paths) found[path] = look_at(path);
        return [this, found = std::move(found)] {
            for (const auto& [path, seen] : found) seen_[path] = seen;
        };
    });
}

void FilePresence::look_above(const std::string& folder) {
    look(folders_above(folder));
}

std::string FilePresence::nearest_folder(const std::string& folder) const {
    for (std::string& here : folders_above(folder)) {
        if (seen(here).state == State::there) return std::move(here);
    }
    return {};
}

FilePresence::Seen FilePresence::seen(const std::string& path) const {
    const auto found = seen_.find(path);
    return found == seen_.end() ? Seen{} : found->second;
}

}  // namespace psicarve::session

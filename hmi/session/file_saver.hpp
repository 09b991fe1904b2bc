// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "hmi/cam/prepared_job.hpp"
#include "hmi/session/background_queue.hpp"
#include "hmi/session/message_log.hpp"
#include "hmi/session/pending_saves.hpp"
#include "hmi/session/trace_judge.hpp"

namespace psicarve::session {

/// Writes the files that an operator saves, on a thread of its own; each result becomes a message. All calls
/// come from one thread, the owner's.
class FileSaver {
public:
    FileSaver(std::string segment_name, std::string group, MessageLog& log, PendingSaves saves = {})
        : segment_name_(std::move(segment_name)),
          group_(std::move(group)),
          log_(log),
          saves_(std::move(saves)) {}

    /// Finishes every save, however long it takes.
    ~FileSaver();
    FileSaver(const FileSaver&) = delete;
    FileSaver& operator=(const FileSaver&) = delete;

    /// The files open in the window: no save overwrites them, whatever their names look like. Asked at each
    /// save.
    void set_files_in_use(std::function<std::vector<std::string>()> files) {
        files_in_use_ = std::move(files);
    }

    /// Job, status and flight recorder of the segment, with a core or without.
    void save_snapshot(const std::string& path);
    using Told = std::function<void(const Phrase& why)>;
    /// The same for the window itself, which opens it in `then`: reports only failures, to `otherwise`, too.
    void take_recorder(const std::string& path, std::function<void()> then, const Told& otherwise);
    void save_job(const std::string& path, std::shared_ptr<const cam::PreparedJob> job);
    /// The job saved last; null: none was, or its last owner is gone.
    std::shared_ptr<const cam::PreparedJob> saved_job() const noexcept { return saved_job_.lock(); }
    /// As CSV, or as JSON where the name ends in .json.
    void save_tables(const std::string& path, std::shared_ptr<const cam::PreparedJob> job);
    /// Writes a finished text to the file as a whole.
    void save_text(const std::string& path, std::string text);
    /// The carved piece as the pins of a trace carved it.
    void save_picture(const std::string& path, std::shared_ptr<const Judgement> judgement);
    /// Call it at screen rate.
    void poll() { queue_.deliver(); }

private:
    /// Refuses a file that is open here under any name: the queue follows links, not the window.
    void post(const std::string& path, BackgroundQueue::Task save, Told otherwise = {});
    BackgroundQueue::Finish told(const Result<void>& done, const std::string& path);

    std::string segment_name_;
    std::string group_;
    MessageLog& log_;
    PendingSaves saves_;
    std::function<std::vector<std::string>()> files_in_use_ = [] { return std::vector<std::string>{}; };
    std::weak_ptr<const cam::PreparedJob> saved_job_;
    BackgroundQueue queue_;  // last: its thread uses the others
};

}  // namespace psicarve::session

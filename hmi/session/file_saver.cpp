// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/file_saver.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <span>
#include <utility>

#include "hmi/machine/machine_link.hpp"
#include "hmi/machine/snapshot_taker.hpp"
#include "hmi/picture/picture.hpp"
#include "hmi/report/job_export.hpp"
#include "shared/file/atomic_file.hpp"
#include "shared/file/distinct_files.hpp"
#include "shared/record/snapshot_file.hpp"

namespace psicarve::session {
namespace {

constexpr std::chrono::milliseconds kSnapshotLimit{5000};

Result<void> snapshot_of_segment(const std::string& path, const std::string& segment,
                                 const std::string& group) {
    auto link = machine::MachineLink::attach(segment, group);
    if (!link) return link.error();
    const auto snapshot = machine::take_snapshot(*link, kSnapshotLimit);
    if (!snapshot) return snapshot.error();
    return save_snapshot(*snapshot, path, group);
}

/// Millions of rows: they are never held in memory.
Result<void> tables_to(const std::string& path, const JobView& job) {
    const auto write = path.ends_with(".json") ? report::write_json : report::write_csv;
    return write_stream_atomically(path, [&](std::FILE* out) { write(job, out); });
}

}  // namespace

FileSaver::~FileSaver() {
    queue_.finish();
    queue_.deliver();
}

void FileSaver::post(const std::string& path, BackgroundQueue::Task save, Told otherwise) {
    const auto unless_open = [this, path, in_use = files_in_use_(), save = std::move(save),
                              otherwise = std::move(otherwise)]() -> BackgroundQueue::Finish {
        const auto is_this = [&path](const std::string& other) { return is_same_file(path, other); };
        if (std::none_of(in_use.begin(), in_use.end(), is_this)) return save();
        return [this, path, otherwise] {
            const Phrase why =
                phrase("Not saved: %1 is open here, and would be lost; choose another name", path);
            log_.add(Severity::warning, why);
            if (otherwise) otherwise(why);
        };
    };
    queue_.post(saves_.noted(path, unless_open));
}

BackgroundQueue::Finish FileSaver::told(const Result<void>& done, const std::string& path) {
    return [this, path, why = done ? std::string{} : done.error().message] {
        if (why.empty()) {
            log_.add(Severity::info, phrase("Saved: %1", path));
        } else {
            log_.add(Severity::warning, phrase("Not saved: %1", why));
        }
    };
}

void FileSaver::save_snapshot(const std::string& path) {
    post(path, [this, path, segment = segment_name_, group = group_] {
        return told(snapshot_of_segment(path, segment, group), path);
    });
}

void FileSaver::take_recorder(const std::string& path, std::function<void()> then, const Told& otherwise) {
    const auto take = [this, path, then = std::move(then), otherwise, segment = segment_name_,
                       group = group_]() -> BackgroundQueue::Finish {
        const auto taken = snapshot_of_segment(path, segment, group);
        if (taken) return then;
        return [tell = told(taken, path), otherwise, why = phrase("Not saved: %1", taken.error().message)] {
            tell();
            otherwise(why);
        };
    };
    post(path, take, otherwise);
}

void FileSaver::save_job(const std::string& path, std::shared_ptr<const cam::PreparedJob> job) {
    post(path, [this, path, job = std::move(job)]() -> BackgroundQueue::Finish {
        Snapshot file;  // a job file is a snapshot without a status
        file.job_blob = job->blob;
        const auto saved = psicarve::save_snapshot(file, path);
        return [this, job, is_saved = saved.has_value(), tell = told(saved, path)] {
            if (is_saved) saved_job_ = job;
            tell();
        };
    });
}

void FileSaver::save_tables(const std::string& path, std::shared_ptr<const cam::PreparedJob> job) {
    post(path, [this, path, job = std::move(job)] { return told(tables_to(path, job->view), path); });
}

void FileSaver::save_text(const std::string& path, std::string text) {
    post(path, [this, path, text = std::move(text)] {
        return told(write_file_atomically(path, std::as_bytes(std::span{text})), path);
    });
}

void FileSaver::save_picture(const std::string& path, std::shared_ptr<const Judgement> judgement) {
    post(path, [this, path, judgement = std::move(judgement)] {
        const auto caption = verify::caption_of(judgement->job->view, judgement->report);
        return told(verify::write_picture(path, judgement->verifier->surface(), caption), path);
    });
}

}  // namespace psicarve::session

// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/checkpoint/piece_memory.hpp"

#include "rtcore/process/words.hpp"
#include "shared/wording/wording.hpp"

namespace psicarve::supervisor {

void PieceMemory::enter(SegmentHeader& header) const {
    header.core.keeping.store(file_.keeping().pack());
    if (keeper_.clear_foreign(header))
        rtcore::try_to_say("the segment's checkpoint is of another kind of machine: it is not taken");
}

std::vector<Message> PieceMemory::take_job(SegmentHeader& header,
                                           const std::shared_ptr<const LoadedJob>& job) {
    keeper_.note_new_job();
    return take_left(header, job);
}

std::vector<Message> PieceMemory::take_left(SegmentHeader& header,
                                            const std::shared_ptr<const LoadedJob>& job) {
    const auto left = file_.left_of(*job);
    if (!left) return {};
    const auto taken = keeper_.take_over(header, left->checkpoint, *job);
    if (taken.to_keep) file_.keep({*taken.to_keep, Keeping::carved}, job);
    std::vector<Message> remarks;
    if (!taken.remark.is_none()) remarks.push_back(taken.remark);
    if (left->profile_hash != profile_hash_ && left->is_unfinished())
        remarks.push_back(message_of(MessageId::begun_with_other_profile));
    return remarks;
}

void PieceMemory::note(SegmentHeader& header, const cycle::Sample& sample,
                       const std::shared_ptr<const LoadedJob>& job) {
    file_.tend();
    header.core.keeping.store(file_.keeping().pack());
    keeper_.note_lost_steps(header, sample);
    // A program carves in the same states, and nothing of the job.
    if (job == nullptr || sample.program.is_running != 0) return;
    if (file_.has_answered_late()) {
        // The job's publisher has its answer already.
        const std::string remark = in_words(take_left(header, job));
        if (!remark.empty()) rtcore::try_to_say(remark);
    }
    const auto to_keep = keeper_.note(header, sample, job.get(), file_.most_told_of(*job));
    if (to_keep) file_.keep(*to_keep, job);
}

Message PieceMemory::forget(SegmentHeader& header, const RecordName& record) {
    if (record.is_simulator != is_simulator_) return message_of(MessageId::record_of_other_kind);
    const bool is_known = keeper_.knows(header, record);
    if (is_known && !file_.is_newest(record)) return message_of(MessageId::record_is_another);
    if (!file_.forget(record)) return message_of(MessageId::forget_disk_silent);
    keeper_.forget(header, record);
    return {};
}

}  // namespace psicarve::supervisor

// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/program/record_intake.hpp"

#include <cstddef>

namespace psicarve::program {

using plan::Supply;

Supply RecordIntake::next(plan::ProgramStep& step) {
    if (over_ == Supply::lost || over_ == Supply::refused) return over_;
    MotionRecord record{};
    RingAnswer answer = feed_.take(record);
    if (answer == RingAnswer::not_yet && over_ == Supply::ended) return over_;
    if (answer == RingAnswer::not_yet && feed_.is_left()) {
        // It may have put more between our look and its end.
        answer = feed_.take(record);
        if (answer == RingAnswer::not_yet) {
            return finish(Supply::lost, line_, message_of(MessageId::program_lost, count_argument(line_)));
        }
    }
    if (answer == RingAnswer::not_yet) return Supply::later;
    return take(answer, record, step);
}

Supply RecordIntake::take(RingAnswer answer, const MotionRecord& record, plan::ProgramStep& step) {
    plan::ProgramStep found;
    const Message fault = fault_of(answer, record, found);
    if (!fault.is_none()) {
        const bool is_line_known = answer == RingAnswer::done && record.program == feed_.program();
        return finish(Supply::refused, is_line_known ? record.line : line_, fault);
    }
    for (std::size_t k = 0; k < kAxisCount; ++k)
        if ((record.axes & (1U << k)) == 0) found.rounded_off_pulses[k] = rounded_off_pulses_[k];
    step = found;
    at_ = found.target_pulses;
    rounded_off_pulses_ = found.rounded_off_pulses;
    taken_ = record.sequence;
    record_sum_ = with_record(record_sum_, record.check);
    line_ = record.line;
    const bool is_end = record.kind == MotionKind::end;
    if (is_end) over_ = Supply::ended;
    feed_.say(taken_, line_, is_end ? ProgramEnd::ended : ProgramEnd::none, record_sum_);
    return Supply::step;
}

Message RecordIntake::fault_of(RingAnswer answer, const MotionRecord& record,
                               plan::ProgramStep& step) const noexcept {
    const Argument line = count_argument(record.line);
    if (answer == RingAnswer::torn) return message_of(MessageId::program_record_torn, count_argument(line_));
    if (answer != RingAnswer::done) return message_of(MessageId::program_ring_damaged);
    if (record.program != feed_.program()) {
        return message_of(MessageId::program_record_foreign, line, count_argument(record.program),
                          count_argument(feed_.program()));
    }
    if (record.sequence != taken_ + 1) {
        return message_of(MessageId::program_record_out_of_order, line, count_argument(record.sequence),
                          count_argument(taken_ + 1));
    }
    if (over_ == Supply::ended) return message_of(MessageId::program_goes_on_after_end, line);
    return rules_.judge(record, at_, step);
}

Supply RecordIntake::finish(Supply how, std::uint64_t line, const Message& why) {
    over_ = how;
    refusal_ = Refusal{line, why};
    // The reason first: who sees the end finds it.
    feed_.say_refusal(line, why);
    feed_.say(taken_, line_, how == Supply::lost ? ProgramEnd::lost : ProgramEnd::refused, record_sum_);
    return how;
}

}  // namespace psicarve::program

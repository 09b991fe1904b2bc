// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/program/decoding.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <utility>

#include "hmi/gcode/machine_check.hpp"
#include "hmi/gcode/machine_options.hpp"
#include "hmi/offsets/settled_offsets.hpp"

namespace psicarve::program {
namespace {

using gcode::CanonKind;
using gcode::CanonRecord;

constexpr int kGivesWayToMachine = 10;
constexpr std::size_t kRestBytes = std::size_t{1} << 16U;

/// Gives canonical motion to all who want it, as long as it is wanted.
class DecodeSinks : public gcode::CanonSink {
public:
    DecodeSinks(std::array<gcode::CanonSink*, 3> sinks, const DecodeProgress& progress) noexcept
        : sinks_(sinks), progress_(progress) {}

    void take(const CanonRecord& record) override {
        for (gcode::CanonSink* const sink : sinks_) sink->take(record);
    }
    void begin_line(const gcode::ReachedLine& line) override {
        for (gcode::CanonSink* const sink : sinks_) sink->begin_line(line);
    }
    bool wants_more() const noexcept override { return !progress_.is_cancelled.load(); }

private:
    std::array<gcode::CanonSink*, 3> sinks_;
    const DecodeProgress& progress_;
};

/// A program's bytes, of which loops and subroutines read some again: the index notes each once.
class CountedBytes {
public:
    CountedBytes(gcode::ProgramBytes bytes, LineIndex& lines, DecodeProgress& progress)
        : bytes_(std::move(bytes)), lines_(lines), progress_(progress) {}

    Result<std::size_t> read(std::span<char> room) {
        if (progress_.is_cancelled.load()) return Error{ErrorCode::cancelled, "cancelled"};
        auto got = bytes_.read(room);
        if (!got) return got;
        const std::uint64_t end = at_ + *got;
        if (end > noted_) {
            const auto fresh = static_cast<std::size_t>(end - noted_);
            lines_.note(room.subspan(*got - fresh, fresh));
            progress_.bytes_done.fetch_add(fresh);
            noted_ = end;
        }
        at_ = end;
        return got;
    }
    Result<void> go_to(std::uint64_t offset) {
        at_ = offset;
        return bytes_.seek(offset);
    }
    gcode::ProgramBytes view() {
        return {[this](std::span<char> room) { return read(room); },
                [this](std::uint64_t offset) { return go_to(offset); }};
    }
    /// What stands behind a program's end is shown, too.
    Result<void> note_rest() {
        if (const auto gone = go_to(noted_); !gone) return gone;
        std::vector<char> room(kRestBytes);
        for (;;) {
            const auto got = read(room);
            if (!got) return got.error();
            if (*got == 0) return {};
        }
    }

private:
    gcode::ProgramBytes bytes_;
    LineIndex& lines_;
    DecodeProgress& progress_;
    std::uint64_t at_ = 0;
    std::uint64_t noted_ = 0;  ///< all bytes before it
};

gcode::InterpreterOptions language_for(const DecodeRequest& request, const gcode::AxisLetters& letters,
                                       const gcode::KeptOffsets& offsets) {
    gcode::InterpreterOptions how = gcode::machine_options(request.profile);
    how.skips_deleted = request.skips_deleted;
    how.offsets = offsets;
    how.is_start_known = request.start.has_value();
    // r1 last: where r2 follows it, one letter stands for both.
    for (const Axis axis : {Axis::r2, Axis::psi, Axis::y, Axis::r1}) {
        if (request.start) how.start[letters.letter_of(axis)] = (*request.start)[index_of(axis)];
    }
    return how;
}

}  // namespace

Result<gcode::KeptOffsets> offsets_for(const DecodeRequest& request) {
    if (request.segment_name.empty()) return gcode::KeptOffsets{};
    const auto settled =
        offsets::settled_offsets(offsets::OffsetsPlace::of(request.segment_name, request.is_simulator),
                                 request.profile.gcode, {request.segment_name, {}});
    if (!settled) return settled.error();
    return settled->offsets.kept;
}

Result<DecodedPointer> decode(const DecodeRequest& request, DecodeProgress& progress) {
    auto decoded = std::make_shared<Decoded>();
    decoded->request = request;
    const auto state = gcode::state_of_program(request.path);
    if (!state) return state.error();
    decoded->state = *state;
    const auto offsets = offsets_for(request);
    if (!offsets) return offsets.error();
    decoded->offsets = *offsets;
    if (!request.segment_name.empty())
        decoded->offsets_path = offsets::OffsetsPlace::of(request.segment_name, request.is_simulator).path;
    progress.bytes_total.store(static_cast<std::uint64_t>(std::max<std::int64_t>(state->bytes, 0)));
    auto opened = gcode::open_unchanged_program(request.path, *state);
    if (!opened) return opened.error();
    CountedBytes bytes{std::move(opened).value(), decoded->lines, progress};
    const gcode::AxisLetters letters{request.profile.gcode};
    gcode::MachineCheck machine{request.profile, decoded->problems};
    PathSketch sketch{letters};
    gcode::ApproachFinder approach{request.profile, std::max(request.from_line, 1U)};
    DecodeSinks sinks{{&machine, &sketch, &approach}, progress};
    gcode::LineSource lines{bytes.view()};
    const auto facts =
        gcode::interpret_program(lines, language_for(request, letters, *offsets), sinks, decoded->problems);
    if (!facts) return facts.error();
    decoded->facts = *facts;
    if (const auto rest = bytes.note_rest(); !rest) return rest.error();
    decoded->path = sketch.finished();
    decoded->approach = approach.found();
    return DecodedPointer{std::move(decoded)};
}

void Decoder::begin(const DecodeRequest& request) {
    cancel();
    path_ = request.path;
    progress_ = std::make_shared<DecodeProgress>();
    work_ = {};
    work_.begin([decode = decode_, request, progress = progress_] {
        ::setpriority(PRIO_PROCESS, 0, kGivesWayToMachine);  // of this thread
        return decode(request, *progress);
    });
}

void Decoder::cancel() noexcept {
    if (progress_) progress_->is_cancelled.store(true);
}

double Decoder::progress_ratio() const noexcept {
    if (!progress_) return 0.0;
    const auto total = static_cast<double>(progress_->bytes_total.load());
    return total > 0.0 ? std::min(static_cast<double>(progress_->bytes_done.load()) / total, 1.0) : 0.0;
}

}  // namespace psicarve::program

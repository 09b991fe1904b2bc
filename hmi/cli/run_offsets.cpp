// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/run_offsets.hpp"

#include <filesystem>
#include <system_error>
#include <utility>

#include "hmi/cli/exit_code.hpp"
#include "hmi/machine/machine_link.hpp"

namespace psicarve::cli {
namespace {

/// Who sets offsets by hand has the lock no longer than that.
constexpr std::chrono::milliseconds kOffsetsHoldLimit{2000};
constexpr std::chrono::seconds kBetweenStores{1};

std::string path_from_root(const std::string& path) {
    if (path.empty()) return {};
    std::error_code error;
    const auto whole = std::filesystem::weakly_canonical(path, error);
    return error ? path : whole.string();
}

}  // namespace

offsets::OffsetsPlace offsets_place(const CommonOptions& common) {
    const auto link = machine::MachineLink::attach(common.segment, common.group);
    const auto status = link && link->core_pid() ? link->last_status() : std::nullopt;
    return offsets::OffsetsPlace::of(common.segment, status && status->is_simulator != 0);
}

Result<offsets::Offsets> kept_offsets(const CommonOptions& common, const Profile& profile) {
    return offsets::read_offsets(offsets_place(common), profile.gcode);
}

Result<RunOffsets> RunOffsets::read(const CommonOptions& common, const Profile& profile, const Run& run) {
    RunOffsets made{offsets_place(common), profile.gcode};
    auto kept = offsets::read_offsets(made.place_, made.letters_);
    if (!kept) return kept.error();
    made.run_ = run;
    made.run_.program = path_from_root(run.program);
    made.begin_ = kept->begin_of(made.run_.program, run.is_from_line);
    made.before_ = *kept;
    made.stored_ = std::move(*kept);
    return made;
}

Result<void> RunOffsets::hold() {
    if (!run_.keeps || !place_.is_kept()) return {};
    auto lock = offsets::OffsetsLock::take(place_, kOffsetsHoldLimit);
    if (!lock && lock.error().code == ErrorCode::machine_refused) return lock.error();
    if (!lock) {
        print_warning(lock.error().message + "; what the program sets ends with it");
        return {};
    }
    const auto now = offsets::read_offsets(place_, letters_);
    if (!now) return now.error();
    if (!(*now == before_))
        return Error{ErrorCode::machine_refused,
                     "the work offsets were changed while the program was checked; nothing has moved, "
                     "run it again"};
    lock_.emplace(std::move(*lock));
    return {};
}

/// What the file is to say. What a program before this one left unfinished goes on with what this one sets.
offsets::Offsets RunOffsets::left_by(const gcode::KeptOffsets& reached, bool is_whole) const {
    offsets::Offsets left = before_;
    left.kept = reached;
    const bool is_ours = left.unfinished && left.unfinished->program == run_.program;
    if (is_whole || run_.program.empty()) {
        if (is_ours) {
            left.unfinished.reset();
        } else if (left.unfinished) {
            offsets::carry_over(begin_, reached, left.unfinished->began_with);
        }
        return left;
    }
    if (!(reached == begin_)) {
        left.unfinished = offsets::Unfinished{run_.program, begin_};
    } else if (is_ours) {
        left.unfinished.reset();
    }
    return left;
}

Result<void> RunOffsets::store(const offsets::Offsets& left) {
    if (left == stored_) return {};
    auto stored = offsets::write_offsets(place_, left, letters_);
    if (stored) stored_ = left;
    return stored;
}

void RunOffsets::watch(gcode::OffsetsLog& log, const ProgramReport& report) {
    if (!lock_) return;
    log.reach(report.status.line, report.progress.taken);
    const auto now = std::chrono::steady_clock::now();
    if (now < next_store_ || !log.has_reached()) return;
    next_store_ = now + kBetweenStores;
    // Where it cannot be written, that is told at the end.
    (void)store(left_by(log.reached(), false));
}

Result<void> RunOffsets::finish(gcode::OffsetsLog& log, const ProgramReport& report, bool is_whole) {
    if (!lock_) return {};
    log.reach(report.status.line, report.progress.taken);
    if (!is_whole && !log.has_reached()) return {};
    auto stored = store(left_by(is_whole ? log.last() : log.reached(), is_whole));
    lock_.reset();
    return stored;
}

void RunOffsets::write_beside(const std::string& trace_path) const {
    std::error_code none;
    if (trace_path.empty() || !std::filesystem::is_regular_file(trace_path, none)) return;
    offsets::OffsetsPlace beside;
    beside.path = offsets::path_beside_trace(trace_path);
    if (const auto written = offsets::write_offsets(beside, {begin_, {}}, letters_); !written)
        print_warning(written.error().message);
}

}  // namespace psicarve::cli

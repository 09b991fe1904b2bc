// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <thread>

#include "hmi/machine/machine_link.hpp"
#include "hmi/machine/pipe_verification.hpp"
#include "hmi/machine/unique_fd.hpp"
#include "shared/base/result.hpp"
#include "shared/job/job.hpp"
#include "shared/machine/recording.hpp"
#include "shared/profile/profile.hpp"
#include "shared/segment/shared_record.hpp"
#include "shared/trace/trace_output.hpp"

namespace psicarve::machine {

/// The pins of a core that another process started: the core records them into the segment, and a thread of
/// ours gives the pieces to the verifier and, if asked for, to a trace file.
class RecordedPins {
public:
    /// Whether a binary file carries the job; to be left out where another job may run.
    enum class FileJob : std::uint8_t { carried, left_out };
    /// Has the core record from here on; it must be at rest. `trace_path` empty: no file. The link and the
    /// job's blob outlive this.
    static Result<std::unique_ptr<RecordedPins>> start(MachineLink& link, const JobView& job,
                                                       const Profile& profile, const std::string& trace_path,
                                                       verify::Verifier::Follower follower = {},
                                                       FileJob file_job = FileJob::carried);
    /// The same into a file alone: nothing is verified, no job is carried.
    static Result<std::unique_ptr<RecordedPins>> start_file(MachineLink& link, const std::string& trace_path);
    ~RecordedPins();
    RecordedPins(const RecordedPins&) = delete;
    RecordedPins& operator=(const RecordedPins&) = delete;

    /// Ends the recording and returns the verification; an error when pieces were lost.
    Result<verify::VerifyReport> finish();
    /// Instead of finish(), of a file alone: why it is not complete.
    Result<void> finish_file();
    /// After finish().
    const verify::CarvedSurface& surface() const noexcept { return verification_->surface(); }
    /// After finish(): why there is no complete trace file, if one was asked for.
    const std::optional<Error>& trace_failure() const noexcept { return trace_failure_; }

private:
    explicit RecordedPins(MachineLink& link) noexcept;
    Result<void> begin(const std::string& trace_path);
    Result<void> ask(RecordingForm form);
    void end();
    Error keep_failure();
    void read_pieces();
    int take_pieces();
    void hand_on(const RecordingPiece& piece);
    void renew() noexcept;
    void write_file(std::span<const std::uint8_t> bytes);

    MachineLink* link_;
    std::uint32_t token_;
    std::uint32_t beat_ = 0;
    RingReader<RecordingPiece, kRecordingPieces> pieces_;
    UniqueFd pipe_;  ///< to the verifier
    std::optional<TraceOutput> file_;
    std::span<const std::byte> job_blob_;  ///< carried by the file behind its head; empty: not carried
    std::unique_ptr<PipeVerification> verification_;
    enum class Phase : std::uint8_t { running, ending, given_up };
    std::atomic<Phase> phase_{Phase::running};
    bool is_whole_ = false;  // written by the thread, read after join
    std::optional<Error> trace_failure_;
    std::thread thread_;
};

}  // namespace psicarve::machine
